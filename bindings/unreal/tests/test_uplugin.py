#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks LangevinRigid.uplugin against its folder: test_uplugin.py PLUGIN"""
import json
import re
import sys
from pathlib import Path

plugin = Path(sys.argv[1])
descriptor = json.loads((plugin / "LangevinRigid.uplugin").read_text())
assert descriptor["FileVersion"] == 3
assert descriptor["EngineVersion"] == "5.4.0"  # as bindings/unreal/test.sh packages it
platforms = set(descriptor["SupportedTargetPlatforms"])
names = {module["Name"] for module in descriptor["Modules"]}
rules = {path.name[:-len(".Build.cs")] for path in plugin.glob("Source/*/*.Build.cs")}
assert names == rules, (names, rules)
for module in descriptor["Modules"]:
    folder = plugin / "Source" / module["Name"]
    assert set(module["PlatformAllowList"]) <= platforms
    sources = "".join(p.read_text() for p in folder.rglob("*.cpp"))
    assert re.search(rf"IMPLEMENT_MODULE\(\w+, {module['Name']}\)", sources), module["Name"]
    assert ("Editor" in module["Name"]) == (module["Type"] == "Editor")
    # A runtime module that needs an editor module cannot be packaged.
    needed = set(re.findall(r'"(\w+)"', (folder / f"{module['Name']}.Build.cs").read_text()))
    if module["Type"] == "Runtime":
        assert not needed & {"UnrealEd", "AssetDefinition", "LangevinRigidEditor"}, module["Name"]
for path in plugin.glob("Source/Langevin*/**/*"):  # shops ask for it
    assert not path.is_file() or path.read_text().startswith("// Copyright Langevin Rigid contributors."), path
icon = (plugin / "Resources/Icon128.png").read_bytes()
assert icon[1:4] == b"PNG" and icon[16:24] == bytes([0, 0, 0, 128] * 2)
header = (plugin / "Source/ThirdParty/LangevinRigidLibrary/include/langevin_rigid.h").read_text()
version = ".".join(re.search(rf"#define LR_VERSION_{part} (\d+)", header).group(1) for part in ("MAJOR", "MINOR", "PATCH"))
assert descriptor["VersionName"] == version, (descriptor["VersionName"], version)
uses_niagara = any('"Niagara"' in path.read_text() for path in plugin.glob("Source/*/*.Build.cs"))
assert uses_niagara == any(p["Name"] == "Niagara" for p in descriptor["Plugins"])
print(f"{len(names)} modules, version {version}")
