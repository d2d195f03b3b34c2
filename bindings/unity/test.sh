#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Compiles the Unity package against a shim of Unity's API, runs it under Mono with the real library, makes the package, and checks it.
#   bindings/unity/test.sh PREFIX     PREFIX: an installed package of the library
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
prefix=${1:?usage: bindings/unity/test.sh PREFIX}
out=$root/build/unity
package=$here/com.langevin.rigid
passed=0 failed=0

finish() { echo "unity: $passed passed, $failed failed${1:-}"; [ "$failed" -eq 0 ]; exit; }
step() { # name, command...
    local name=$1 log=$out/log.txt
    shift
    if "$@" >"$log" 2>&1; then
        passed=$((passed + 1)); echo "unity: $name: good"
    else
        failed=$((failed + 1)); echo "unity: $name: FAILED"; sed 's/^/    /' "$log"
        return 1
    fi
}

rm -rf "$out"
mkdir -p "$out/files"
echo "unity: compiled against a hand-written SHIM of Unity's API (bindings/unity/shim), NOT by Unity: no engine runs here"

step "metas are what metas.py writes" python3 "$here/metas.py" check "$package"
step "package is made" python3 "$here/package.py" --native "$prefix" --out "$out/package" --tgz
step "package is the same each time" bash -c "mkdir '$out/again' && python3 '$here/package.py' --native '$prefix' --out '$out/again' --tgz && \
    diff -r '$out/package' '$out/again'"
step "packages that are not good are refused" python3 "$here/tests/package_faults.py" "$out/package/com.langevin.rigid" "$prefix" "$out/faults"
built=$out/package/com.langevin.rigid
step "bundled baker runs" "$built/Tools~/linux-x64/lr_bake" mesh "$root/assets/leaf.obj" -o "$out/leaf.lrb" --density 350 --quiet

if ! command -v mcs >/dev/null || ! command -v mono >/dev/null; then
    echo "SKIPPED: C# of the Unity package, for want of mcs and mono: apt-get install mono-mcs mono-runtime libmono-corlib4.5-cil libmono-system-core4.0-cil"
    finish ", 1 skipped"
fi
compiler=(mcs -langversion:latest -unsafe -warnaserror -warn:4 -nologo)
# 0649, 0169: fields that Unity fills from saved scenes.
unity=("${compiler[@]}" -target:library -nowarn:0649,0169)
cd "$out"
shim=()
for name in Mathematics Scene Attributes Physics Collections Rendering; do shim+=("$here/shim/$name.cs"); done
step "shim compiles" "${compiler[@]}" -target:library -out:UnityEngine.dll "${shim[@]}" &&
    step "editor shim compiles" "${unity[@]}" -out:UnityEditor.dll -r:UnityEngine.dll "$here/shim/Editor.cs" &&
    step "test framework compiles" "${compiler[@]}" -target:library -out:nunit.framework.dll "$here/shim/TestFramework.cs" || finish

# Compiled as Unity does: for the editor, with and without Burst, and for players.
sources() { find "$1" -name '*.cs' | sort; }
compile_all() { # folder, defines
    mkdir -p "$1"
    "${compiler[@]}" -target:library -d:"$2" -out:"$1/LangevinRigid.dll" $(sources "$built/Runtime/Bindings") &&
        "${unity[@]}" -d:"$2" -out:"$1/LangevinRigid.Unity.dll" -r:UnityEngine.dll -r:"$1/LangevinRigid.dll" \
            $(find "$built/Runtime" -maxdepth 1 -name '*.cs' | sort) || return 1
    case $2 in *UNITY_EDITOR*)
        "${unity[@]}" -d:"$2" -out:"$1/LangevinRigid.Unity.Editor.dll" -r:UnityEngine.dll -r:UnityEditor.dll -r:"$1/LangevinRigid.dll" \
            -r:"$1/LangevinRigid.Unity.dll" $(sources "$built/Editor") ;;
    esac
}
for set in "editor UNITY_EDITOR;UNITY_2022_3_OR_NEWER" "burst UNITY_EDITOR;UNITY_2022_3_OR_NEWER;LANGEVIN_BURST" \
    "player UNITY_STANDALONE;ENABLE_IL2CPP;LANGEVIN_BURST" "webgl UNITY_WEBGL;ENABLE_IL2CPP"; do
    step "package compiles: $set" compile_all "${set%% *}" "${set#* }" || finish
done

all=(-r:UnityEngine.dll -r:UnityEditor.dll -r:nunit.framework.dll -r:editor/LangevinRigid.dll -r:editor/LangevinRigid.Unity.dll
    -r:editor/LangevinRigid.Unity.Editor.dll)
step "package's own tests compile" "${unity[@]}" -out:PackageTests.dll "${all[@]}" $(sources "$built/Tests") &&
    step "sample compiles" "${unity[@]}" -d:UNITY_EDITOR -out:Sample.dll "${all[@]}" $(sources "$built/Samples~") &&
    step "tests compile" "${compiler[@]}" -nowarn:0649 -target:exe -out:Tests.exe "${all[@]}" -r:Sample.dll $(sources "$here/tests") || finish
cp editor/*.dll .

run=$out/run.txt
LR_TEST_LEAF=$out/leaf.lrb LR_TEST_FOLDER=$out/files LR_TEST_BAKER=$built/Tools~/linux-x64/lr_bake LR_TEST_PACKAGE=$built \
    LD_LIBRARY_PATH=$built/Runtime/Plugins/Linux/x86_64 timeout 110 mono --debug Tests.exe Tests.exe PackageTests.dll >"$run" 2>&1
code=$?
grep -v '^RESULT' "$run" | sed 's/^/unity: /'
if result=$(grep '^RESULT' "$run"); then
    read -r _ good bad <<<"$result"
    passed=$((passed + good)) failed=$((failed + bad))
else
    failed=$((failed + 1)); echo "unity: the tests did not come to an end (exit code $code)"
fi
for name in Main Job left; do step "lr_replay: recording $name" "$prefix/bin/lr_replay" "$out/files/$name.lrrec"; done
finish
