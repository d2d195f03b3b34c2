#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Tests the source kit as a new user: unpacked alone in an empty folder; by its README's one line with GCC, for a platform without a system and
# without vector extensions; by CMake with clang, installed and used by another project; and by CMake with Emscripten, if that is installed. All
# must give the held hash.
#   packaging/check_source_kit.sh ARCHIVE [recipes|gcc|clang|emscripten ...]
set -euo pipefail
archive=$(realpath "${1:?which archive}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
source scripts/compiler_cache.sh
shift
work=$(mktemp -d "${TMPDIR:-/tmp}/source_kit.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
export CCACHE_BASEDIR=$work
tar xf "$archive"
kit=$(echo "$work"/*)
jobs=${LR_JOBS:-$(nproc)}
same_hash() { "$@" | grep -Fxf "$root/packaging/hello.hash" >/dev/null || { echo "not the held hash: $*" >&2; return 1; }; }

check_gcc() { # the flags of the README's line, file by file
    local flags files
    flags=$(sed -n 's/^ *g++ \(-std=.*\) \\$/\1/p' "$kit/README.md")
    [ -n "$flags" ]
    mkdir gcc
    cd "$kit"
    files=$(find src third_party -name '*.cpp' -o -name '*.cc' -o -name '*.c')
    # shellcheck disable=SC2086
    printf '%s\n' $files | xargs -P "$jobs" -I{} bash -c 'compiler=g++ source={} flags=$*
        case $source in *.c) compiler=gcc flags=${flags/-std=c++20/} ;; esac
        ccache=$(command -v ccache || true)
        $ccache $compiler $flags -DLR_NO_OS -DLR_PLAIN_FLOAT4 -Iinclude -Isrc -Ithird_party -c $source -o ../gcc/${source//\//_}.o' _ $flags
    cd ..
    ar rcs gcc/lib.a gcc/*.o
    gcc -std=c99 -DLR_STATIC -I"$kit/include" "$kit/samples/hello.c" gcc/lib.a -lstdc++ -lm -o gcc/hello
    same_hash gcc/hello
    g++ -std=c++20 -DLR_STATIC -I"$kit/include" "$root/tests/source_kit/no_os.cpp" gcc/lib.a -o gcc/no_os
    gcc/no_os
    # Nothing of the system: names of C in the list, and no threads, clocks or files of C++.
    nm -u gcc/lib.a | awk 'NF == 2 { print $2 }' | sort -u >gcc/undefined
    nm --defined-only gcc/lib.a | awk 'NF == 3 { print $3 }' | sort -u | comm -23 gcc/undefined - >gcc/imports
    if grep -v '^_Z' gcc/imports | grep -vxFf "$root/tests/source_kit/imports.txt"; then
        echo "LR_NO_OS: imported, but not in tests/source_kit/imports.txt" >&2
        return 1
    fi
    if grep '^_Z' gcc/imports | c++filt | grep -E 'thread|chrono|mutex|condition|filesystem|stream|random_device'; then
        echo "LR_NO_OS: uses the system through C++" >&2
        return 1
    fi
    echo "GCC, LR_NO_OS: held hash; $(wc -l <gcc/imports) imports"
}
check_clang() {
    local clang
    clang=$(command -v clang++-14 || command -v clang++) || { echo "SKIPPED: clang: not installed"; return; }
    cmake -S "$kit" -B clang -G Ninja "-DCMAKE_CXX_COMPILER=$clang" "-DCMAKE_C_COMPILER=${clang/++/}" -DLR_BUILD_SHARED_TOO=ON \
        "-DCMAKE_INSTALL_PREFIX=$work/prefix" -DCMAKE_INSTALL_LIBDIR=lib >clang.log 2>&1 || { cat clang.log; return 1; }
    cmake --build clang -j "$jobs" >clang.log 2>&1 || { tail -n 40 clang.log; return 1; }
    cmake --install clang >clang.log
    "$root/tests/installed_package/check.sh" "$work/prefix" "$work/outside"
    # Projects of C alone, in both ways of the README.
    local way use
    for way in found added; do
        use='find_package(langevin_rigid CONFIG REQUIRED)'
        [ $way = found ] || use="add_subdirectory($kit langevin_rigid)"
        mkdir "$way"
        printf '%s\n' 'cmake_minimum_required(VERSION 3.16)' 'project(game LANGUAGES C)' "$use" "add_executable(hello $kit/samples/hello.c)" \
            'target_link_libraries(hello PRIVATE langevin_rigid::static)' >"$way/CMakeLists.txt"
        { cmake -S "$way" -B "$way-build" -G Ninja "-DCMAKE_CXX_COMPILER=$clang" "-DCMAKE_C_COMPILER=${clang/++/}" "-DCMAKE_PREFIX_PATH=$work/prefix" &&
            cmake --build "$way-build" -j "$jobs"; } >clang.log 2>&1 || { tail -n 40 clang.log; return 1; }
        same_hash "$way-build/hello"
    done
    diff <(nm -D --defined-only prefix/lib/liblangevin_rigid.so | awk '$2 == "T" { print $3 }' | sort) <(sort "$root/tests/api/exports.txt")
    echo "clang, CMake: held hash, installed and used"
}
check_emscripten() { # the archive that a web player links, and Godot's extension in a stand-in for the engine
    command -v emcmake >/dev/null || { echo "SKIPPED: Emscripten: scripts/setup.sh test emscripten"; return; }
    build() { # FOLDER SOURCE [OPTION...]
        { emcmake cmake -S "$2" -B "$1" -G Ninja "${@:3}" && cmake --build "$1" -j "$jobs"; } >emscripten.log 2>&1 || { tail -n 40 emscripten.log; return 1; }
    }
    build emscripten "$kit" "-DCMAKE_INSTALL_PREFIX=$work/web" -DCMAKE_INSTALL_LIBDIR=lib
    cmake --install emscripten >emscripten.log
    emcc -O2 -DLR_STATIC -I"$kit/include" -c "$kit/samples/hello.c" -o emscripten/hello.o
    em++ emscripten/hello.o emscripten/liblangevin_rigid_static.a -o emscripten/hello.js
    # This Emscripten's loader takes fetch() for a browser's.
    same_hash node --no-experimental-fetch emscripten/hello.js
    build godot "$root/bindings/godot" "-Dlangevin_rigid_DIR=$work/web/lib/cmake/langevin_rigid" -DLANGEVIN_GODOT_WERROR=ON
    emcc -O1 -std=gnu99 -D_GNU_SOURCE "$root"/bindings/godot/tests/host/*.c -sMAIN_MODULE=1 -sNODERAWFS=1 -sALLOW_MEMORY_GROWTH -sTOTAL_STACK=1MB \
        -o godot/host.js 2>emscripten.log || { cat emscripten.log; return 1; }
    mkdir help
    LR_HOST_HELP=$work/help node --no-experimental-fetch godot/host.js godot/addons/langevin_rigid/bin/web_wasm32/langevin_rigid_godot.wasm \
        "$root/tests/abi/0.2/leaf.lrb"
    echo "Emscripten: held hash in node, and Godot's extension in a stand-in for the engine"
}
check_recipes() { # what can be said without vcpkg and Conan: all that they name exists
    local version
    version=$(sed -n 's/^project(langevin_rigid VERSION \([0-9.]*\).*/\1/p' "$kit/CMakeLists.txt")
    python3 - "$kit" "$version" <<'PY'
import ast, json, re, sys
from pathlib import Path
kit, version = Path(sys.argv[1]), sys.argv[2]
port = json.loads((kit / "vcpkg/langevin-rigid/vcpkg.json").read_text())
assert port["version"] == version, port
text = (kit / "vcpkg/langevin-rigid/portfile.cmake").read_text()
recipe = (kit / "conanfile.py").read_text()
tree = ast.parse(recipe)
patterns = next(ast.literal_eval(n.value) for n in ast.walk(tree) if isinstance(n, ast.Assign) and n.targets[0].id == "exports_sources")
for pattern in patterns:
    assert list(kit.glob(pattern)), f"conanfile.py exports {pattern}, which is not there"
cmake = (kit / "CMakeLists.txt").read_text()
assert re.search(r"project\(langevin_rigid VERSION ([0-9.]+)", cmake).group(1) == version
for option in re.findall(r"-D([A-Z_]+)=", text) + re.findall(r'cache_variables\["(\w+)"\]', recipe):
    assert f"option({option} " in cmake, f"no option {option} in CMakeLists.txt"
for target in re.findall(r"langevin_rigid::(\w+)", cmake):
    assert target in recipe, target
for path in (kit / "LICENSE", kit / "third_party/licences/highway.txt"):
    assert path.stat().st_size > 300, path
assert "@" not in re.sub(r"\S+@\S+", "", text), "a placeholder is left"
PY
    # The port, run by CMake with stand-ins for vcpkg's functions: folders and options.
    cat >port.cmake <<'CMAKE'
function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
    if(NOT EXISTS "${arg_SOURCE_PATH}/CMakeLists.txt" OR arg_UNPARSED_ARGUMENTS)
        message(FATAL_ERROR "no sources in ${arg_SOURCE_PATH}")
    endif()
endfunction()
function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
    list(LENGTH arg_FILE_LIST count)
    foreach(file IN LISTS arg_FILE_LIST)
        if(NOT EXISTS "${file}" OR count LESS 4)
            message(FATAL_ERROR "terms: ${arg_FILE_LIST}")
        endif()
    endforeach()
endfunction()
foreach(name vcpkg_cmake_install vcpkg_cmake_config_fixup vcpkg_fixup_pkgconfig vcpkg_copy_pdbs)
    cmake_language(EVAL CODE "function(${name})\nendfunction()")
endforeach()
set(VCPKG_LIBRARY_LINKAGE static)
set(CURRENT_PACKAGES_DIR "${CMAKE_CURRENT_BINARY_DIR}/packages")
include("${PORT}")
CMAKE
    cmake "-DPORT=$kit/vcpkg/langevin-rigid/portfile.cmake" -P port.cmake
    echo "recipes: vcpkg's port and Conan's recipe name what is there ($version)"
}
[ $# -gt 0 ] || set -- recipes gcc clang emscripten
for check; do "check_$check"; cd "$work"; done
