# SPDX-License-Identifier: MIT
"""Checks Blender's zip by the rules of Blender 4.2 for extensions, as far as they can be checked without it:  extension_check.py ZIP"""
import re
import sys
import tomllib
import zipfile

TAGS = {"3D View", "Add Curve", "Add Mesh", "Animation", "Bake", "Camera", "Compositing", "Development", "Game Engine", "Geometry Nodes",
        "Grease Pencil", "Import-Export", "Lighting", "Material", "Mesh", "Modeling", "Node", "Object", "Paint", "Physics", "Pipeline",
        "Render", "Rigging", "Scene", "Sculpt", "Sequencer", "System", "Text Editor", "Tracking", "User Interface", "UV"}
REQUIRED = {"schema_version", "id", "version", "name", "tagline", "maintainer", "type", "blender_version_min", "license"}

with zipfile.ZipFile(sys.argv[1]) as archive:
    names = archive.namelist()
    manifests = [name for name in names if name.endswith("/blender_manifest.toml")]
    assert len(manifests) == 1 and manifests[0].count("/") == 1, manifests  # at the root or in the only folder
    folder = manifests[0].split("/")[0]
    assert all(name.startswith(folder + "/") for name in names), "one folder, as add-ons before 4.2 need"
    manifest = tomllib.loads(archive.read(manifests[0]).decode())
    source = archive.read(f"{folder}/__init__.py").decode()

assert REQUIRED <= manifest.keys(), REQUIRED - manifest.keys()
assert manifest["schema_version"] == "1.0.0" and manifest["type"] == "add-on"
assert re.fullmatch("[a-z][a-z0-9_]*", manifest["id"]) and manifest["id"] == folder
assert re.fullmatch(r"\d+\.\d+\.\d+", manifest["version"])
assert str(tuple(map(int, manifest["version"].split(".")))) in source, "bl_info has the same version"
assert all(entry.startswith("SPDX:") for entry in manifest["license"])
assert set(manifest["tags"]) <= TAGS, set(manifest["tags"]) - TAGS
for text in (manifest["tagline"], *manifest["permissions"].values()):
    assert len(text) <= 64 and text == text.strip() and text[-1].isalnum(), text
assert manifest["permissions"].keys() <= {"files", "network", "clipboard", "camera", "microphone"}
assert set(manifest["platforms"]) <= {"linux-x64", "windows-x64", "windows-arm64", "macos-x64", "macos-arm64"}
for wheel in manifest["wheels"]:
    assert wheel.startswith("./wheels/") and len(wheel.split("-")) in (5, 6) and f"{folder}/{wheel[2:]}" in names, wheel
print(f"{folder} {manifest['version']}: {len(names)} files for {', '.join(manifest['platforms'])}")
