#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Tests a package as a new user: unpacks it in an empty folder, checks its files, compiles against it in each way of its README, and runs
# the result without access to this tree.
#   packaging/check_package.sh ARCHIVE
set -euo pipefail
archive=$(realpath "${1:?which archive}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/platforms.sh
root=$PWD
name=$(basename "$archive")
name=${name%.tar.xz}
name=${name%.zip}
select_platform "${name#langevin_rigid-*-}"
work=$root/build/packaging/check/$name
rm -rf "$work"
mkdir -p "$work"
cd "$work"
export WINEDEBUG=${WINEDEBUG:--all}
unset LD_LIBRARY_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH

source "$root/packaging/checks.sh"
finish() {
    echo "package $name: $passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}

unpack() { case $archive in *.zip) unzip -q "$archive" ;; *) tar xf "$archive" ;; esac; }
check "unpacks" unpack
one_folder() { [ "$(ls -A | grep -vx check.log)" = "$name" ]; }
check "unpacks into one folder of its name" one_folder
cd "$name" || { finish; exit 1; }
prefix=$PWD

# Contents.
check "checksums" sha256sum --quiet --strict -c SHA256SUMS
all_summed() { diff <(find . -type f ! -name SHA256SUMS -printf '%P\n' | sort) <(sed 's/^[0-9a-f]*  //' SHA256SUMS | sort); }
check "every file has a checksum" all_summed
expected=(README.md LICENSE THIRD_PARTY.md include/langevin_rigid.h include/langevin_rigid.hpp include/langevin_rigid_research.h "$library" "bin/lr_bake$exe" "bin/lr_drop$exe" "bin/lr_replay$exe" samples/hello.c
    lib/cmake/langevin_rigid/langevin_rigid-config.cmake lib/pkgconfig/langevin_rigid.pc assets/leaf.lrb assets/leaf.obj)
[ "$platform" != windows-x64 ] || expected+=(lib/langevin_rigid.lib lib/langevin_rigid.def lib/liblangevin_rigid.dll.a)
for file in "${expected[@]}"; do check "has $file" test -s "$file"; done
for header in langevin_rigid.h langevin_rigid.hpp langevin_rigid_research.h; do check "$header is the tree's" cmp "include/$header" "$root/include/$header"; done
licences() { # every file in the table exists and has terms; licences named by others exist
    local file
    grep -o 'licences/[a-z0-9-]*\.txt' THIRD_PARTY.md | sort -u >"$work/named"
    [ "$(wc -l <"$work/named")" -ge 12 ] || { echo "only $(wc -l <"$work/named") in THIRD_PARTY.md"; return 1; }
    while read -r file; do
        [ "$(wc -c <"$file")" -ge 300 ] || { echo "$file: missing or empty"; return 1; }
        grep -qiE 'licen[sc]e|copyright' "$file" || { echo "$file: no terms in it"; return 1; }
    done <"$work/named"
    grep -ohE '/usr/share/common-licenses/[A-Za-z0-9.-]*[A-Za-z0-9]' licences/*.txt | sed 's|.*/||' | sort -u | while read -r file; do
        [ -s "licences/$file.txt" ] || { echo "licences/$file.txt is missing, to which others refer"; exit 1; }
    done
}
check "licences of all that it carries" licences
no_paths() { # no file contains a path of the build machine
    local bad
    bad=$(grep -rlaF -e "$root" -e build/packag . || true)
    [ -z "$bad" ] || { echo "$bad"; grep -raohE "[[:print:]]*($root|build/packag)[[:print:]]*" $bad | head -n 5; return 1; }
}
check "no folders of the machine that built it" no_paths

# Needed libraries and exports.
if [ "$platform" = windows-x64 ]; then
    exports() {
        x86_64-w64-mingw32-objdump -p "$library" |
            sed -n '/Ordinal\/Name Pointer/,/^$/p' | sed -n 's/^[[:space:]]*\[ *[0-9]*\] //p' | sort
    }
    needs() { x86_64-w64-mingw32-objdump -p "$1" | sed -n 's/.*DLL Name: //p' | sort -u; }
    system='^(KERNEL32|msvcrt|SHELL32|ADVAPI32|USER32)\.dll$'
else
    exports() { nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort; }
    needs() { readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | sort -u; }
    system='^(libc\.so\.6|libm\.so\.6|libpthread\.so\.0|ld-linux-(x86-64|aarch64)\.so\.[12])$'
fi
same_exports() { diff <(sort "$root/tests/api/exports.txt") <(exports); }
check "exports the header's functions and nothing else" same_exports
only_system() { local others; others=$(needs "$1" | grep -vE "$system" || true); [ -z "$others" ] || { echo "$others"; return 1; }; }
check "the library needs only the system's C library" only_system "$library"
check "lr_bake needs only the system's C library" only_system "bin/lr_bake$exe"
check "lr_drop needs only the system's C library" only_system "bin/lr_drop$exe"
security=$root/tests/security
check "imports are those in its list" "$security/check_imports.sh" "$library" "$security/imports-package-${platform/linux-*/linux}.txt"
check "hardened" "$security/check_hardening.sh" "$library" "bin/lr_bake$exe" "bin/lr_drop$exe"
if [ "$platform" != windows-x64 ]; then
    stated() { grep -q "needs glibc $("$root/packaging/glibc_floor.sh" "$library") or later and nothing else; lr_bake needs glibc $(
        "$root/packaging/glibc_floor.sh" bin/lr_bake) or later" README.md; }
    check "README says which glibc" stated
    at_most() { [ "$(printf '%s\n' "$2" "$("$root/packaging/glibc_floor.sh" "$1")" | sort -V | tail -n 1)" = "$2" ]; }
    check "the library runs on glibc 2.17" at_most "$library" 2.17
    check "lr_bake runs on glibc 2.31" at_most bin/lr_bake 2.31
    check "lr_drop runs on glibc 2.31" at_most bin/lr_drop 2.31
    no_rpath() { ! readelf -d "$library" "bin/lr_bake" "bin/lr_drop" | grep -E 'RPATH|RUNPATH|TEXTREL'; }
    check "no run path and no text relocations" no_rpath
fi

# The ways of its README, from other folders, with a moved copy.
mv "$prefix" "$work/moved there"
prefix="$work/moved there"
cd "$work"
case $platform in
linux-x64) compiler=(cc) ;;
linux-arm64) compiler=(aarch64-linux-gnu-gcc) ;;
windows-x64) compiler=(x86_64-w64-mingw32-gcc-posix) ;;
esac
run() { # program
    (cd "$(dirname "$1")" && env -i HOME="$HOME" PATH=/usr/bin:/bin WINEDEBUG="$WINEDEBUG" WINEPREFIX="${WINEPREFIX:-$HOME/.wine}" "${runner[@]}" "$1")
}
says_hash() { # program; the hash must be equal for all ways and platforms
    run "$1" >"$1.txt" && grep -E '^state [0-9a-f]{16} after 2 s' "$1.txt" | tr -d '\r' >"$1.hash"
}
warnings=(-std=c99 -Wall -Wextra -Wpedantic -Werror)
beside() { [ "$platform" != windows-x64 ] || cp "$prefix/bin/langevin_rigid.dll" "$1"; }
mkdir plain pkg-config
by_hand() {
    "${compiler[@]}" "${warnings[@]}" -I"$prefix/include" "$prefix/samples/hello.c" -L"$prefix/lib" -llangevin_rigid \
        -Wl,-rpath,"$prefix/lib" -o "plain/hello$exe" && beside plain
}
check "hello.c by hand" by_hand
check "and it runs" says_hash "$work/plain/hello$exe"
by_pkg_config() {
    local flags
    flags=$(PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig" pkg-config --cflags --libs langevin_rigid) || return 1
    eval "set -- $flags"
    "${compiler[@]}" "${warnings[@]}" "$prefix/samples/hello.c" "$@" -Wl,-rpath,"$prefix/lib" -o "pkg-config/hello$exe" && beside pkg-config
}
check "hello.c by pkg-config" by_pkg_config
check "and it runs" says_hash "$work/pkg-config/hello$exe"
by_cmake() {
    # Cross toolchain files search packages only in CMAKE_FIND_ROOT_PATH.
    cmake -S "$prefix/samples" -B cmake "${toolchain[@]}" "-DCMAKE_PREFIX_PATH=$prefix" "-DCMAKE_FIND_ROOT_PATH=$prefix" \
        -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF && cmake --build cmake
}
check "hello.c by CMake" by_cmake
check "and it runs" says_hash "$work/cmake/hello$exe"
check "and the one with the static library, without others" says_hash "$work/cmake/hello_static$exe"
sinks() { run "$work/cmake/coin$exe" | tr -d '\r' | tail -n 1 | grep -E '^at rest after [0-9.]+ s, 1\.99[0-9] m deep$'; }
check "and the tutorial's coin" sinks
alone() { needs "$1" | grep -i -e langevin -e stdc && return 1 || true; }
check "which needs none of them" alone "$work/cmake/hello_static$exe"
global() { # COFF: of C alone
    local others
    others=$(nm -g --defined-only "$prefix/lib/liblangevin_rigid_static.a" | awk 'NF == 3 { print $3 }' | grep -v '^lr_' || true)
    [ "$platform" != windows-x64 ] || others=$(grep -vE '^(_Z|__emutls_v|\.refptr\.)' <<<"$others" || true)
    [ -z "$others" ] || { echo "$others"; return 1; }
}
check "global symbols of the static library" global
if [ "$platform" = windows-x64 ] && command -v clang-14 >/dev/null && command -v lld-link >/dev/null; then
    mkdir microsoft
    by_lld() { # import library in Microsoft's format; MinGW's start-up code replaces Microsoft's
        "${compiler[@]}" -c -std=c99 -I"$prefix/include" "$prefix/samples/hello.c" -o microsoft/hello.o &&
            "${compiler[@]}" microsoft/hello.o "$prefix/lib/langevin_rigid.lib" -o microsoft/hello.exe && beside microsoft
    }
    check "hello.c with langevin_rigid.lib" by_lld
    check "and it runs" says_hash "$work/microsoft/hello.exe"
fi
# A held hash like tests/determinism/golden.txt. To update it after a change of motion: LR_HOLD=1 packaging/check_package.sh ARCHIVE
[ -z "${LR_HOLD:-}" ] || cp plain/*.hash "$root/packaging/hello.hash"
same_hash() { [ "$(sort -u ./*/hello*.hash | wc -l)" = 1 ] && diff <(sort -u ./*/hello*.hash) "$root/packaging/hello.hash"; }
check "every way gives the hash in packaging/hello.hash" same_hash

# The baker: equal bytes from the moved copy, in a folder with a non-ASCII name, and faults with numbers.
mkdir "bäked 葉"
bake() { (cd "$work" && env -i HOME="$HOME" PATH=/usr/bin:/bin WINEDEBUG="$WINEDEBUG" WINEPREFIX="${WINEPREFIX:-$HOME/.wine}" LC_ALL=C.UTF-8 "${runner[@]}" "$prefix/bin/lr_bake$exe" "$@"); }
check "lr_bake bakes a mesh" bake mesh "moved there/assets/leaf.obj" -o "bäked 葉/葉.lrb" --density 350 --quiet
same_asset() { # which x86-64 Linux has baked: other builds of lr_bake name themselves in it, and MinGW differs in the 16th digit
    [ "$platform" != linux-x64 ] || { cmp "bäked 葉/葉.lrb" "$prefix/assets/leaf.lrb"; return; }
    local file
    for file in "bäked 葉/葉.lrb" "moved there/assets/leaf.lrb"; do bake info "$file" --json | tr -d '\r' >"$(basename "$file").json" || return; done
    python3 - 葉.lrb.json leaf.lrb.json <<'PY'
import json, math, sys
def same(a, b, at=""):
    if isinstance(a, dict): return all(same(a[k], b[k], f"{at}.{k}") for k in a) and a.keys() == b.keys()
    if isinstance(a, list): return len(a) == len(b) and all(same(x, y, at) for x, y in zip(a, b))
    good = math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-15) if isinstance(a, float) else a == b
    if not good: print(at, a, b)
    return good
a, b = (json.load(open(path, encoding="utf-8")) for path in sys.argv[1:])
a.pop("provenance"), b.pop("provenance") # another build of lr_bake
sys.exit(not same(a, b))
PY
}
check "equal to the package's asset" same_asset
check "lr_bake reads it again" bake check "bäked 葉/葉.lrb"
"$root/packaging/write_meshes.py" meshes
draco=$root/build/sources/draco/testdata/Box/glTF_Binary/Box_Draco.glb
[ ! -f "$draco" ] || cp "$draco" meshes/draco.glb # a cube of 1 m, compressed
weighs() { # mesh of 1 m^3: 500 kg at 500 kg/m^3
    bake mesh "meshes/$1" -o "meshes/$1.lrb" --unit m --density 500 --quiet && bake info "meshes/$1.lrb" --json | tee -a /dev/stderr |
        python3 -c 'import json, sys; m = json.load(sys.stdin)["mass"]; sys.exit(not abs(m - 500) < 1e-3)'
}
for mesh in meshes/*; do check "lr_bake reads $(basename "$mesh")" weighs "$(basename "$mesh")"; done
drops() { (cd "$work" && env -i HOME="$HOME" PATH=/usr/bin:/bin WINEDEBUG="$WINEDEBUG" WINEPREFIX="${WINEPREFIX:-$HOME/.wine}" LC_ALL=C.UTF-8 "${runner[@]}" "$prefix/bin/lr_drop$exe" "bäked 葉/葉.lrb" --count 50 --png "bäked 葉/葉.png" &&
    [ -s "bäked 葉/葉.png" ]); }
check "lr_drop drops it and draws a picture" drops
wrong_usage() { local status=0; bake mesh || status=$?; [ "$status" -eq 2 ]; } # throws through the bundled unwinder
check "lr_bake ends wrong usage with 2" wrong_usage
refuses() { ! bake mesh no_such.obj -o x.lrb --density 350 2>refused.txt && grep -q 101 refused.txt && [ ! -e x.lrb ]; }
check "lr_bake reports a numbered fault" refuses
lines_of_pages() ( # each as it is, in a folder with the package's `bin` and `assets`
    mkdir lines && cd lines && ln -s "$prefix"/{bin,assets} . && sed -n 's/^    \(lr_\(bake\|drop\) .*\|bin\/lr_.*\)$/\1/p' "$root"/docs/guide/{tutorial,recipes}.md >all &&
        [ "$(wc -l <all)" -ge 9 ] && PATH=$prefix/bin:$PATH bash -ex all
)
[ "$platform" != linux-x64 ] || check "the lines of tutorial and recipes" lines_of_pages
for page in engines languages; do check "the page of $page" test -s "$prefix/docs/guide/$page.md"; done
held=$(cat "$root/packaging/hello.hash")
if [ "$platform" = linux-x64 ]; then
    if command -v mcs >/dev/null; then
        by_mono() {
            mkdir mono && find "$prefix/bindings/csharp/src" -name '*.cs' -print0 |
                xargs -0 mcs -nologo -unsafe -langversion:latest -out:mono/hello.exe "$prefix/bindings/csharp/samples/Hello.cs" &&
                LD_LIBRARY_PATH="$prefix/lib" mono mono/hello.exe | grep -x "$held.*" >/dev/null
        }
        check "C#, with the same bits" by_mono
    else
        echo "SKIPPED: C#: mono-mcs is not installed"
    fi
fi
for asset in "$prefix"/assets/*.lrb; do check "$(basename "$asset") is sound" bake check "moved there/assets/$(basename "$asset")"; done
finish
