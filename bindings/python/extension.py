#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the zip that Blender installs:  extension.py PREFIX DIR

PREFIX: an installed package, as for wheel.sh. Blender 4.2 and later take the zip as an extension and install the wheel in it; older
ones take it as an add-on, which unpacks the wheel itself. The same input gives the same bytes.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ADDON = HERE / "blender" / "leaf_storm"
PARTS = {"__init__.py", "__main__.py", "caches.py", "carrier.py", "colliders.py", "command.py", "keyframes.py", "leaf.py", "nodes.py",
         "operators.py", "package.py", "panel.py", "picture.py", "simulate.py", "storm.py", "units.py", "wind.py"}
PLATFORMS = {r"manylinux_\d+_\d+_x86_64": "linux-x64", "win_amd64": "windows-x64"}  # of those that blender.org builds for
CARRIED = ("langevin_rigid/__init__.py", "langevin_rigid/export/__init__.py", r"langevin_rigid/lib/(liblangevin_rigid\.so\.\d+|langevin_rigid\.dll)",
           r"langevin_rigid/bin/lr_bake(\.exe)?", r"langevin_rigid/lib/licences/.+")
MANIFEST = """schema_version = "1.0.0"
id = "leaf_storm"
version = "{version}"
name = "Leaf Storm (Langevin Rigid)"
tagline = "Bakes falling leaves, paper and petals to instances"
maintainer = "Langevin Rigid"
type = "add-on"
tags = ["Physics", "Animation", "Bake"]
blender_version_min = "4.2.0"
license = ["SPDX:MIT"]
platforms = ["{platform}"]
wheels = ["./wheels/{wheel}"]

[permissions]
files = "Reads leaves and assets, and writes caches"
"""


def fail(text):
    sys.exit(f"extension.py: {text}")


def check_wheel(path):
    """The version and the platform of a wheel that has all its parts."""
    name = re.fullmatch(r"langevin_rigid-([0-9.]+)-py3-none-(\w+)\.whl", path.name)
    platform = next((value for pattern, value in PLATFORMS.items() if name and re.fullmatch(pattern, name[2])), None)
    if platform is None:
        fail(f"{path.name}: not a wheel for a platform of Blender")
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
    for pattern in CARRIED:
        if not any(re.fullmatch(pattern, entry) for entry in names):
            fail(f"{path.name} lacks {pattern}")
    return name[1], platform


def write(path, files):
    """Files as an archive whose bytes depend only on names and contents."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, data in sorted(files.items()):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.external_attr, entry.create_system = 0o100644 << 16, 3
            # The wheel is compressed already.
            archive.writestr(entry, data, zipfile.ZIP_STORED if name.endswith(".whl") else zipfile.ZIP_DEFLATED)


def main(prefix, out):
    found = {path.name for path in ADDON.glob("*.py")}
    if found != PARTS:
        fail(f"parts of the add-on are missing or not listed: {', '.join(sorted(found ^ PARTS))}")
    with tempfile.TemporaryDirectory() as work:
        if subprocess.run([HERE / "wheel.sh", prefix, work], stdout=subprocess.DEVNULL, check=False).returncode:
            fail("the wheel could not be made")
        wheel, = pathlib.Path(work).glob("*.whl")
        version, platform = check_wheel(wheel)
        files = {path.name: path.read_bytes() for path in ADDON.glob("*.py")}
        files["__init__.py"], stated = re.subn(rb'"version": \(0, 0, 0\)', b'"version": (%s)' % version.replace(".", ", ").encode(),
                                               files["__init__.py"])
        if stated != 1:
            fail("blender/leaf_storm/__init__.py has no place for the version")
        files[f"wheels/{wheel.name}"] = wheel.read_bytes()
        files["LICENSE"] = (HERE / "../../LICENSE").read_bytes()
        files["blender_manifest.toml"] = MANIFEST.format(version=version, platform=platform, wheel=wheel.name).encode()
    path = pathlib.Path(out) / f"leaf_storm-{version}-{platform}.zip"
    path.parent.mkdir(parents=True, exist_ok=True)
    write(path, {f"leaf_storm/{name}": data for name, data in files.items()})
    print(path)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
