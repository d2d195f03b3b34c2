#!/usr/bin/env bash
# Builds and runs all tests of the Unreal plugin against an installed library: test.sh PREFIX
# Needs no engine: bindings/unreal/shim replaces it. With LR_WIN64_PREFIX and LR_LINUXARM64_PREFIX, libraries installed for those
# platforms are packaged too; otherwise small stand-ins that export the same functions.
# SPDX-License-Identifier: MIT
set -uo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"
prefix="$(cd "${1:?usage: test.sh PREFIX}" && pwd)" || exit 2
build="$root/build/unreal"
gen="$build/gen"
objects="$build/objects"
mkdir -p "$objects"
passed=0 failed=0 skipped=0

step() { # NAME COMMAND...
    local name="$1"
    shift
    if "$@" >"$build/log.txt" 2>&1; then
        passed=$((passed + 1))
        echo "ok      $name"
    else
        failed=$((failed + 1))
        echo "FAILED  $name"
        sed 's/^/        /' "$build/log.txt" | tail -40
    fi
}
skip() {
    skipped=$((skipped + 1))
    echo "SKIPPED: $1"
}
have() { command -v "$1" >/dev/null; }

plugin="$here/LangevinRigid"
mapfile -t headers < <(find "$plugin/Source" "$here/samples" -name '*.h' -not -path '*/ThirdParty/*' | sort)
mapfile -t sources < <(find "$plugin/Source" "$here/samples" -name '*.cpp' | sort)
flags=(-std=c++20 -Wall -Wextra -Wshadow -Werror -I"$gen" -I"$here/shim" -I"$here/samples"
    -I"$plugin/Source/LangevinRigid/Public" -I"$plugin/Source/LangevinRigid/Private"
    -I"$plugin/Source/LangevinRigidNiagara/Public" -I"$plugin/Source/LangevinRigidEditor/Public"
    -isystem "$prefix/include" -DLANGEVINRIGID_API= -DLANGEVINRIGIDNIAGARA_API= -DLANGEVINRIGIDEDITOR_API=
    '-DLANGEVIN_RIGID_LIBRARY="lib/Linux/liblangevin_rigid.so.0"')

# ---------------------------------------------------------------------------------------------------------------------
# Sources against the shim
step "header tool: generated headers, properties and functions that Blueprints know" \
    python3 "$here/shim/header_tool.py" "$gen" "${headers[@]}"
step "header tool refuses what the engine's refuses" "$here/tests/test_header_tool.sh" "$build/header_tool"

alone() { # COMPILER FILE...: compiles each file alone; headers through a source that includes nothing else
    local compiler="$1"
    shift
    printf '%s\0' "$@" | compiler="$compiler" xargs -0 -P 2 -n 1 bash -c \
        'printf "#include \"%s\"\n" "${@: -1}" | "$compiler" "${@:1:$#-1}" -x c++ -fsyntax-only -' _ "${flags[@]}"
}
if have clang++-14; then
    step "clang++-14: ${#sources[@]} sources" alone clang++-14 "${sources[@]}"
else
    skip "the check by clang++-14, for want of it: apt-get install clang-14"
fi
step "g++: ${#headers[@]} headers, each alone (sources: below)" alone g++ "${headers[@]}"

# The engine compiles a module as one or a few sources that include the others: file-local names must not collide.
unity() {
    local module
    for module in LangevinRigid LangevinRigidNiagara LangevinRigidEditor; do
        find "$plugin/Source/$module" -name '*.cpp' | sort | sed 's/.*/#include "&"/' >"$build/unity_$module.cpp"
        g++ "${flags[@]}" -fsyntax-only "$build/unity_$module.cpp" || return 1
    done
}
step "unity builds of all modules" unity
step "no test-only name of the shim in the plugin" bash -c "! grep -rnE '\\bb?Shim[A-Z]' '$plugin/Source' '$here/samples'"

# ---------------------------------------------------------------------------------------------------------------------
# Packages and build rules
win64="${LR_WIN64_PREFIX:-}" arm64="${LR_LINUXARM64_PREFIX:-}"
platforms=(Linux)
native=(--native "Linux=$prefix")
if [[ -z $win64 ]]; then
    if have x86_64-w64-mingw32-gcc; then
        step "a stand-in for the library on Windows" "$here/tests/make_stand_in.sh" Win64 "$prefix" "$build/stand_in/Win64"
        win64="$build/stand_in/Win64"
    else
        skip "Win64 package, for want of mingw: apt-get install g++-mingw-w64-x86-64-posix"
    fi
fi
if [[ -z $arm64 ]]; then
    if have aarch64-linux-gnu-gcc; then
        step "a stand-in for the library on ARM64" "$here/tests/make_stand_in.sh" LinuxArm64 "$prefix" "$build/stand_in/LinuxArm64"
        arm64="$build/stand_in/LinuxArm64"
    else
        skip "LinuxArm64 package, for want of a compiler: apt-get install gcc-aarch64-linux-gnu"
    fi
fi
[[ -n $win64 ]] && platforms+=(Win64) && native+=(--native "Win64=$win64")
[[ -n $arm64 ]] && platforms+=(LinuxArm64) && native+=(--native "LinuxArm64=$arm64")
step "package.py: ${platforms[*]}" python3 "$here/package.py" "${native[@]}" --engine 5.4.0 --out "$build/plugin"
step "package.py refuses what cannot work" "$here/tests/test_package.sh" "$here/package.py" "$prefix" "$build/refused"
step "the script of the sample map, against a stand-in for the editor's Python" python3 "$here/tests/test_sample.py" "$build/plugin/LangevinRigid"
step "the .uplugin names modules that are there" python3 "$here/tests/test_uplugin.py" "$build/plugin/LangevinRigid"
if [[ -n $win64 ]] && have x86_64-w64-mingw32-gcc; then
    step "the import library: MinGW and lld link, and delay-load, by it" "$here/tests/test_import_library.sh" \
        "$build/plugin/LangevinRigid/Source/ThirdParty/LangevinRigidLibrary" "$build/import_library"
fi
if have mcs && have mono; then
    rules() {
        mcs -out:"$build/build_rules.exe" "$here/tests/build_rules.cs" \
            $(find "$build/plugin/LangevinRigid" -name '*.Build.cs') &&
            mono "$build/build_rules.exe" "$build/plugin/LangevinRigid" "${platforms[@]}"
    }
    step "Build.cs of all modules, run for ${platforms[*]} and Mac: all files are there" rules
    rules_alone() {
        python3 "$here/package.py" --native "$prefix" --out "$build/plugin_linux" &&
            mono "$build/build_rules.exe" "$build/plugin_linux/LangevinRigid" Linux
    }
    step "Build.cs of a package for one platform: the others are refused with what to do" rules_alone
else
    skip "Build.cs, for want of Mono: apt-get install mono-mcs mono-runtime"
fi

# ---------------------------------------------------------------------------------------------------------------------
# The plugin, linked with the library and run
if [[ -f /usr/include/doctest/doctest.h ]]; then
    step "bake a leaf" "$prefix/bin/lr_bake" mesh "$root/assets/leaf.obj" -o "$build/leaf.lrb" --density 350 --quiet
    compile() {
        local list="$build/compile.txt"
        printf '%s\0' "${sources[@]}" "$here"/shim/*.cpp "$here"/tests/*.cpp >"$list"
        export objects
        # shellcheck disable=SC2016
        xargs -0 -P 2 -n 1 bash -c 'g++ "${@:1:$#-1}" -c "${@: -1}" -o "$objects/$(basename "${@: -1}" .cpp).o"' _ \
            "${flags[@]}" <"$list"
    }
    step "g++: ${#sources[@]} sources, shim and tests" compile
    mapfile -t plugin_objects < <(for f in "${sources[@]}" "$here"/shim/*.cpp "$here"/tests/test_[^c]*.cpp \
        "$here"/tests/test_colliders.cpp; do echo "$objects/$(basename "$f" .cpp).o"; done)
    step "link the conversion's tests" g++ -DDOCTEST_CONFIG_IMPLEMENT_WITH_MAIN -std=c++20 -Wall -Wextra -Werror \
        -I"$plugin/Source/LangevinRigid/Public" -I"$plugin/Source/LangevinRigid/Private" -isystem "$prefix/include" \
        "$here/tests/test_conversion.cpp" -o "$build/test_conversion"
    step "conversion: numbers by hand, round trips, handedness" "$build/test_conversion"
    tail -2 "$build/log.txt" | sed 's/^/        /'
    packaged="$build/plugin/LangevinRigid/Source/ThirdParty/LangevinRigidLibrary/lib/Linux"
    step "link the plugin with the packaged library" g++ "${plugin_objects[@]}" -L"$packaged" -llangevin_rigid \
        -Wl,-rpath,"$packaged" -ldl -pthread -o "$build/test_plugin"
    export LANGEVIN_TEST_LEAF="$build/leaf.lrb" LANGEVIN_TEST_PLUGIN="$build/plugin/LangevinRigid" LANGEVIN_TEST_RECORDINGS="$build"
    step "plugin: module, assets, import, bodies, colliders, wind, Niagara, sample" "$build/test_plugin"
    tail -2 "$build/log.txt" | sed 's/^/        /'
    for name in game left; do step "lr_replay: recording $name" "$prefix/bin/lr_replay" "$build/$name.lrrec"; done
else
    skip "the running plugin, for want of doctest: apt-get install doctest-dev"
fi

echo "unreal: $passed passed, $failed failed$([[ $skipped -gt 0 ]] && echo ", $skipped skipped")"
[[ $failed -eq 0 ]]
