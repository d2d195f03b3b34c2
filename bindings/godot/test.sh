#!/usr/bin/env bash
# Builds the extension against an installed package and tests it: bindings/godot/test.sh PREFIX
# With an engine (GODOT, or godot4 or godot on the PATH; 4.4 or later) also tests in the engine, headless.
# SPDX-License-Identifier: MIT
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(cd "$here/../.." && pwd)
prefix=$(cd "${1:?usage: test.sh PREFIX}" && pwd) || exit 2
build=$tree/build/godot
export LD_LIBRARY_PATH="$prefix/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
passed=0 failed=0 skipped=0
mkdir -p "$build"

# step NAME COMMAND...: prints one line, and the log of a failed command
step() {
    local name=$1 log
    shift
    log=$build/$(tr -c 'a-z0-9\n' _ <<<"$name").log
    if "$@" >"$log" 2>&1; then
        echo "passed: $name$(grep -E '^(speed|state|[a-z ]+: [0-9]+ passed)' "$log" | sed 's/^/; /' | tr -d '\n')"
        passed=$((passed + 1))
    else
        echo "FAILED: $name"
        tail -40 "$log"
        failed=$((failed + 1))
        return 1
    fi
}

compile_extension() {
    cmake -S "$here" -B "$build/addon" -DCMAKE_PREFIX_PATH="$prefix" -DLANGEVIN_GODOT_WERROR=ON &&
        cmake --build "$build/addon" --parallel 2
}

transforms() {
    cc -std=c99 -Wall -Wextra -Werror -g -fsanitize=address,undefined "$here/src/transform.c" \
        "$here/tests/test_transform.c" -lm -o "$build/test_transform" && "$build/test_transform"
}

# The addon must need no library but the system's and what is beside it, list that for exports, and export only its entry.
addon_is_whole() {
    local bin others
    bin=$(echo "$build"/addon/addons/langevin_rigid/bin/linux_*)
    (unset LD_LIBRARY_PATH && ldd "$bin/langevin_rigid_godot.so") >"$build/ldd.txt" || return 1
    ! grep -e 'not found' -e liblangevin "$build/ldd.txt" || return 1
    others=$(sed -n "s|.* => $bin/\([^ ]*\) .*|\1|p" "$build/ldd.txt")
    diff <(ls "$bin" | sort) <(printf '%s\n' langevin_rigid_godot.so $others | sort) || return 1
    for file in langevin_rigid_godot.so $others; do grep -F "/${bin##*/}/$file\"" "$bin/../../langevin_rigid.gdextension" || return 1; done
    [ "$(nm -D --defined-only "$bin/langevin_rigid_godot.so" | awk '{print $3}')" = langevin_rigid_init ]
}

fake_host() {
    local sources=()
    for source in "$here"/src/*.c "$here"/src/gd/*.c; do sources+=("$source"); done
    cc -std=c99 -Wall -Wextra -Werror -g -O1 -fPIC -shared -fsanitize=address,undefined -fno-omit-frame-pointer \
        -I"$prefix/include" "${sources[@]}" -L"$prefix/lib" -llangevin_rigid -lm -o "$build/extension_asan.so" &&
        cc -std=c99 -D_GNU_SOURCE -Wall -Wextra -Werror -g -O1 -fsanitize=address,undefined -fno-omit-frame-pointer \
            "$here"/tests/host/*.c -ldl -lm -o "$build/host" &&
        bake "$tree/assets/leaf.obj" "$build/leaf.lrb" &&
        ASAN_OPTIONS=detect_leaks=1 LR_HOST_HELP=$build "$build/host" "$build/extension_asan.so" "$build/leaf.lrb"
}
help_is_whole() { # of each class, and each of its members
    python3 - "$build" <<'PY'
import sys
import xml.etree.ElementTree as tree
pages = [tree.parse(f"{sys.argv[1]}/help_{n}.xml").getroot() for n in (1, 2, 3)]
assert [p.get("name") for p in pages] == ["LangevinAsset", "LangevinWorld", "LangevinBatch"]
for page in pages:
    texts = page.findall("brief_description") + page.findall(".//method/description") + page.findall(".//member") + page.findall(".//constant")
    assert len(texts) > 10 and all((t.text or "").strip() for t in texts), page.get("name")
    assert not [t for t in page.iter() if t.get("type") == "Variant"], page.get("name")
PY
}

bake() { "$prefix/bin/lr_bake" mesh "$1" -o "$2" --density 350 --quiet; }

engine() { env -u LD_LIBRARY_PATH HOME="$build/home" timeout 60 "$godot" --headless "$@"; }

compare_abi() {
    local cc_flags=(-std=gnu11 -Wall -Wextra -Werror -I"$build/dump" -fsyntax-only)
    mkdir -p "$build/dump" && (cd "$build/dump" && engine --dump-gdextension-interface --quit) &&
        cc "${cc_flags[@]}" "$here/tests/abi/compare_with_engine.c" || return 1
    # Checks that the comparison can fail: with a parameter of another width, and with an additional field.
    mkdir -p "$build/broken/src/abi" "$build/broken/tests/abi"
    cp "$here/tests/abi/compare_with_engine.c" "$build/broken/tests/abi"
    for change in 's/void\* self, const void\* method, const void\* const\* args, int64_t count/void* self, const void* method, const void* const* args, int32_t count/' \
        's/^    uint8_t is_runtime;/    uint8_t is_runtime; void* more;/'; do
        sed "$change" "$here/src/abi/gdextension_abi.h" >"$build/broken/src/abi/gdextension_abi.h"
        ! cmp -s "$here/src/abi/gdextension_abi.h" "$build/broken/src/abi/gdextension_abi.h" || return 1
        ! cc "${cc_flags[@]}" "$build/broken/tests/abi/compare_with_engine.c" 2>/dev/null || return 1
    done
    # Each looked-up name is in the engine's list.
    grep -oE '^    X\([a-z0-9_]+' "$here/src/abi/gdextension_abi.h" | cut -c7- | while read -r name; do
        grep -q "@name $name\$" "$build/dump/gdextension_interface.h" || { echo "$name is not in the engine"; exit 1; }
    done
}

# Unannounced error messages of the engine are failures: at the end of a run they report leaks of objects and RIDs.
no_complaints() {
    local expected=0 found
    expected=$(grep -oE '\([0-9]+ expected\)' "$1" | tr -dc '0-9\n' | awk '{sum += $1} END {print sum + 0}')
    found=$(grep -cE '^(SCRIPT )?ERROR|^WARNING' "$1")
    [ "$found" -eq "$expected" ] || { echo "$found errors and warnings, $expected were expected"; return 1; }
}

project() {
    rm -rf "$build/project"
    mkdir -p "$build/project/.godot" "$build/home"
    cp -r "$build/addon/addons" "$here"/tests/engine/* "$build/project" &&
        printf 'config_version=5\n[application]\nconfig/name="test"\n' >"$build/project/project.godot" &&
        echo 'res://addons/langevin_rigid/langevin_rigid.gdextension' >"$build/project/.godot/extension_list.cfg" &&
        awk '/^v /{$2 = $2 + 0.5} {print}' "$tree/assets/leaf.obj" >"$build/shifted.obj" &&
        bake "$tree/assets/leaf.obj" "$build/project/leaf.lrb" && bake "$build/shifted.obj" "$build/project/shifted.lrb" &&
        engine --path "$build/project" --import
}

in_engine() {
    engine --path "$build/project" --script res://test_engine.gd >"$build/engine.txt" 2>&1
    local result=$?
    cat "$build/engine.txt"
    no_complaints "$build/engine.txt" && return $result
}

recording() { "$prefix/bin/lr_replay" "$build/project/fall.lrrec"; }

demo() {
    rm -rf "$build/demo_project"
    "$here/demo.sh" "$prefix" "$build/demo_project" && engine --path "$build/demo_project" --import || return 1
    engine --path "$build/demo_project" --fixed-fps 60 --quit-after 120 >"$build/demo.txt" 2>&1 || return 1
    cat "$build/demo.txt"
    no_complaints "$build/demo.txt"
}

# The editor with the demo's scene open: nodes exist but do not run.
editor() {
    engine --path "$build/demo_project" --editor --quit-after 60 res://addons/langevin_rigid/demo/storm.tscn >"$build/editor.txt" 2>&1 || return 1
    cat "$build/editor.txt"
    no_complaints "$build/editor.txt"
}

sample() {
    cp "$here/sample.gd" "$build/project" && engine --path "$build/project" --script res://sample.gd >"$build/sample.txt" 2>&1 || return 1
    cat "$build/sample.txt"
    no_complaints "$build/sample.txt" && grep -qE '^leaf 9: fell [1-9]' "$build/sample.txt"
}

step "extension, c99, warnings are errors" compile_extension && step "addon has what it needs beside it" addon_is_whole
step "transforms" transforms
[ -d "$here/tests/host" ] && step "a host of our own, with address sanitizer" fake_host && step "the editor's help" help_is_whole
godot=${GODOT:-$(command -v godot4 || command -v godot || true)}
if [ -n "$godot" ]; then
    step "declarations against the engine's header" compare_abi
    step "project is imported" project && step "in the engine" in_engine && step "what it recorded, played again" recording && step "sample" sample
    step "demo runs" demo && step "demo in the editor" editor
else
    echo "SKIPPED: tests in the engine, for want of Godot 4.4 or later: set GODOT=/path/to/godot, or put it on the PATH"
    skipped=1
fi
echo "godot: $passed passed, $failed failed$([ $skipped -eq 0 ] || echo ", $skipped skipped")"
[ "$failed" -eq 0 ]
