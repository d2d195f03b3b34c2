#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Tests the packages for Godot, Unity and Unreal as far as that goes without the engines: each is unpacked in an empty folder, its layout
# checked, and used there: Godot's extension in the host of the tests, Unity's package compiled and its tools run, Unreal's plugin by the rules
# of its Build.cs. Prints the time of each.
#   packaging/check_engines.sh FOLDER     FOLDER: of the packages
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
packages=$(realpath "${1:?which folder}")
work=$(mktemp -d "${TMPDIR:-/tmp}/engines.XXXXXX")
trap 'rm -rf "$work"' EXIT
unset LD_LIBRARY_PATH
source packaging/checks.sh
package() { echo "$packages"/langevin_rigid-*-"$1"; }
no_paths() { ! grep -rlaF -e "$root" -e build/packag "$1"; }
summed() { (cd "$1" && sha256sum --quiet --strict -c SHA256SUMS); }
needs_system_only() { # file
    case $1 in
    *.dll | *.exe) ! x86_64-w64-mingw32-objdump -p "$1" | sed -n 's/.*DLL Name: //p' | grep -ivE '^(KERNEL32|msvcrt|SHELL32|ADVAPI32|USER32)\.dll$' ;;
    *) ! readelf -d "$1" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | grep -vE '^(lib(c|m|pthread)\.so\.[06]|ld-linux.*)$' ;;
    esac
}
at_most() { [ "$(printf '%s\n' "$2" "$(packaging/glibc_floor.sh "$1")" | sort -V | tail -n 1)" = "$2" ]; }
lap=$SECONDS
finish() { echo "$1: $((SECONDS - lap)) s"; lap=$SECONDS; }

# Godot: the Asset Library unpacks it into a project.
project=$work/project
addon=$project/addons/langevin_rigid
check "Godot: unpacks" unzip -q "$(package godot.zip)" -d "$project"
only_addon() { [ "$(ls -A "$project")" = addons ] && [ "$(ls -A "$project/addons")" = langevin_rigid ] && [ -s "$addon/LICENSE" ]; }
check "Godot: nothing outside addons/langevin_rigid, and a licence in it" only_addon
check "Godot: checksums" summed "$addon"
check "Godot: no folders of the machine that built it" no_paths "$addon"
paths_exist() { # of the extension's file and of the scene; and every binary is named
    local file
    grep -rhoE 'res://addons/[A-Za-z0-9_./]+' "$addon" --include='*.gdextension' --include='*.tscn' | sort -u | sed 's|^res://||' >"$work/named"
    while read -r file; do [ -s "$project/$file" ] || { echo "no $file"; return 1; }; done <"$work/named"
    (cd "$project" && find addons/langevin_rigid/bin -type f) | while read -r file; do grep -qxF "$file" "$work/named" || { echo "$file is not named"; exit 1; }; done
}
check "Godot: every file that is named is there, and every library named" paths_exist
for file in "$addon"/bin/{linux,windows}_*/*; do
    check "Godot: ${file#"$addon"/} needs the system alone" needs_system_only "$file"
    case $file in *.so) check "Godot: ${file#"$addon"/} runs on glibc 2.28" at_most "$file" 2.28 ;; esac
done
in_host() { # the packaged binary, in the tests' host
    cc -std=c99 -D_GNU_SOURCE -g -O1 "$root"/bindings/godot/tests/host/*.c -ldl -lm -o "$work/host" &&
        LR_HOST_HELP=$work "$work/host" "$addon/bin/linux_x86_64/langevin_rigid_godot.so" "$addon/demo/leaf.lrb"
}
check "Godot: the library of the package in the tests' host" in_host
finish godot

# Unity: the package manager unpacks it into its cache.
check "Unity: unpacks" tar -xzf "$(package unity.tgz)" -C "$work"
unity=$work/package
whole() { python3 -c 'import sys; sys.path.insert(0, "bindings/unity"); import pathlib, package; faults = package.check(pathlib.Path(sys.argv[1])); print(*faults, sep="\n"); sys.exit(bool(faults))' "$unity"; }
check "Unity: metas, GUIDs, references of the scene and the prefab, assemblies, versions" whole
check "Unity: no folders of the machine that built it" no_paths "$unity"
for file in "$unity"/Runtime/Plugins/{Linux,Windows}/*/*.{so,dll} "$unity"/Tools~/*/lr_bake*; do
    [ ! -e "$file" ] || check "Unity: ${file#"$unity"/} needs the system alone" needs_system_only "$file"
done
unity_bakes() { "$unity/Tools~/linux-x64/lr_bake" mesh "$unity/Samples~/LeafStorm/leaf.obj" -o "$work/leaf.lrb" --density 350 --quiet && cmp "$work/leaf.lrb" "$unity/Samples~/LeafStorm/leaf.lrb"; }
check "Unity: its baker bakes its leaf" unity_bakes
binding_runs() { # the C# in the package, with the library in it
    mcs -nologo -unsafe -langversion:latest "-out:$work/hello.exe" $(find "$unity/Runtime/Bindings" -name '*.cs') "$root/bindings/csharp/samples/Hello.cs" &&
        LD_LIBRARY_PATH=$unity/Runtime/Plugins/Linux/x86_64 mono "$work/hello.exe" | grep -x "$(cat "$root/packaging/hello.hash").*"
}
if command -v mcs >/dev/null && command -v mono >/dev/null; then check "Unity: its binding falls with the held bits" binding_runs; else echo "SKIPPED: Unity's binding: mono-mcs is not installed"; fi
finish unity

# Unreal: into a project's Plugins.
mkdir "$work/Plugins"
check "Unreal: unpacks" unzip -q "$(package unreal.zip)" -d "$work/Plugins"
plugin=$work/Plugins/LangevinRigid
native=$plugin/Source/ThirdParty/LangevinRigidLibrary
check "Unreal: checksums" summed "$plugin"
check "Unreal: no folders of the machine that built it" no_paths "$plugin"
descriptor() { sed 's/assert descriptor\["EngineVersion"\].*//' bindings/unreal/tests/test_uplugin.py | python3 - "$plugin"; }
check "Unreal: the .uplugin names what is there" descriptor
check "Unreal: the script of the sample map" python3 bindings/unreal/tests/test_sample.py "$plugin"
for file in "$native"/lib/*/*.{so.0,dll} "$native"/bin/*/*; do
    [ ! -e "$file" ] || check "Unreal: ${file#"$native"/} needs the system alone" needs_system_only "$file"
done
unreal_bakes() { "$native/bin/Linux/lr_bake" mesh "$root/assets/leaf.obj" -o "$work/leaf.lrb" --density 350 --quiet && [ -s "$work/leaf.lrb" ]; }
check "Unreal: its baker bakes a leaf" unreal_bakes
rules() {
    mcs "-out:$work/build_rules.exe" bindings/unreal/tests/build_rules.cs $(find "$plugin" -name '*.Build.cs') &&
        mono "$work/build_rules.exe" "$plugin" $(ls "$native/lib")
}
if command -v mcs >/dev/null && command -v mono >/dev/null; then check "Unreal: Build.cs finds its libraries" rules; else echo "SKIPPED: Unreal's Build.cs: mono-mcs is not installed"; fi
finish unreal

# Addresses of the project, where the publisher gives them.
addresses() {
    local file
    mkdir "$work/unity_json" "$work/npm_json" && cp "$unity/package.json" "$work/unity_json/" && cp bindings/web/package.json "$work/npm_json/" &&
        cp "$plugin/LangevinRigid.uplugin" "$work/" || return
    for file in "$work"/{unity_json,npm_json}/package.json "$work/LangevinRigid.uplugin"; do
        ! LR_HOME=example.org packaging/addresses.py "$file" 2>/dev/null || return
        LR_HOME=https://example.org/leaves/ LR_REPOSITORY=https://example.org/leaves.git packaging/addresses.py "$file" || return
    done
    python3 - "$work" <<'PY'
import json, sys
unity, npm, unreal = (json.load(open(f"{sys.argv[1]}/{name}")) for name in ("unity_json/package.json", "npm_json/package.json", "LangevinRigid.uplugin"))
guide = "https://example.org/leaves/docs/docs/guide"
assert unity["documentationUrl"] == f"{guide}/engines.html#unity" and unity["author"]["url"] == "https://example.org/leaves"
assert unity["changelogUrl"].endswith("/docs/CHANGELOG.html") and unity["licensesUrl"].endswith("/docs/LICENSE.html")
assert npm["homepage"] == f"{guide}/languages.html#web" and npm["repository"] == {"type": "git", "url": "https://example.org/leaves.git"}
assert unreal["DocsURL"] == f"{guide}/engines.html#unreal-engine" and unreal["CreatedByURL"] == unreal["SupportURL"] == "https://example.org/leaves"
PY
}
check "Addresses of the project are written, and none that is no address" addresses

echo "engines: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
