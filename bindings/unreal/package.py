#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the Unreal plugin together with native libraries: a folder to be dropped into a project's Plugins/.

    package.py --native Linux=/opt/langevin_rigid --native Win64=C:/langevin_rigid --out MyProject/Plugins

PREFIX is where the library was installed (include/, lib/, bin/). PLATFORM= may be left out: it is then read from the
library itself. --also adds a file beside the library that it needs at run time (libhwy.so.1, a C++ runtime).
"""
import argparse
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import native_file  # noqa: E402

PLATFORMS = {("pe", "x86_64"): "Win64", ("elf", "x86_64"): "Linux", ("elf", "aarch64"): "LinuxArm64"}
THIRD_PARTY = Path("Source/ThirdParty/LangevinRigidLibrary")


def fail(text: str) -> None:
    sys.exit("package.py: " + text)


def find_library(prefix: Path) -> Path:
    for pattern in ("bin/*langevin_rigid*.dll", "lib/*langevin_rigid*.dll", "lib/liblangevin_rigid.so",
                    "lib/*/liblangevin_rigid.so", "lib64/liblangevin_rigid.so"):
        for path in sorted(prefix.glob(pattern)):
            return path
    if list(prefix.glob("lib/*.dylib")):
        fail(f"{prefix} has a library for macOS, which the plugin does not support yet")
    fail(f"no langevin_rigid library in {prefix}: is it an install prefix (cmake --install BUILD --prefix PREFIX)?")


def put(source: Path, target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)  # follows links: plugin folders travel through zip files and version control
    print(f"  {target}")


def package_native(plugin: Path, native: str, also: list) -> str:
    wanted, _, rest = native.rpartition("=")
    prefix = Path(rest)
    library = find_library(prefix)
    described = native_file.describe(library)
    platform = PLATFORMS.get((described.format, described.machine))
    if platform is None:
        fail(f"{library}: {described.format} for {described.machine}, which Unreal has no platform for")
    if wanted and wanted != platform:
        fail(f"{library} is for {platform}, not for {wanted}")
    header = prefix / "include/langevin_rigid.h"
    if not header.is_file():
        fail(f"{header} is missing")
    shipped = plugin / THIRD_PARTY / "include/langevin_rigid.h"
    if shipped.is_file() and shipped.read_bytes() != header.read_bytes():
        fail(f"{header} differs from that of another --native: all must be of one version")
    put(header, shipped)

    for licence in sorted((prefix / "share/doc/langevin_rigid").glob("*")):
        if licence.is_file():
            put(licence, plugin / "Licenses" / licence.name)

    folder = plugin / THIRD_PARTY / "lib" / platform
    if platform == "Win64":
        put(library, folder / library.name)
        target = folder / "langevin_rigid.lib"
        target.write_bytes(native_file.import_library(library.name, native_file.pe_exports(library)))
        print(f"  {target}")
    else:
        # The linker takes the plain name, the loader asks for the name inside.
        put(library, folder / "liblangevin_rigid.so")
        if described.soname and described.soname != "liblangevin_rigid.so":
            put(library, folder / described.soname)
    missing = []
    for needed in described.needed:
        beside = [p for p in [library.parent / needed, prefix / "bin" / needed, *(Path(a) for a in also)]
                  if p.name.lower() == needed.lower() and p.is_file()
                  and native_file.describe(p).machine == described.machine]
        if beside:
            put(beside[0], folder / beside[0].name)
        elif not native_file.is_system(needed):
            missing.append(needed)
    for name in missing:
        print(f"package.py: warning: {library.name} needs {name}, which is not in {prefix}: machines without it cannot "
              f"load the plugin. Give it by --also FILE, or link it statically.", file=sys.stderr)
    return platform


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--native", action="append", required=True, metavar="[PLATFORM=]PREFIX")
    parser.add_argument("--also", action="append", default=[], metavar="FILE")
    parser.add_argument("--out", required=True, type=Path, metavar="DIR", help="where LangevinRigid/ is written")
    arguments = parser.parse_args()
    here = Path(__file__).resolve().parent
    plugin = arguments.out / "LangevinRigid"
    if plugin.exists() and not (plugin / "LangevinRigid.uplugin").is_file():
        fail(f"{plugin} exists and is not this plugin")
    shutil.rmtree(plugin, ignore_errors=True)
    shutil.copytree(here / "LangevinRigid", plugin,
                    ignore=shutil.ignore_patterns("lib", "include", "Binaries", "Intermediate", "__pycache__"))
    licence = here.parent.parent / "LICENSE"
    if licence.is_file():
        shutil.copyfile(licence, plugin / "LICENSE")
    done = [package_native(plugin, native, arguments.also) for native in arguments.native]
    if len(set(done)) != len(done):
        fail("two of --native are for the same platform")
    print(f"{plugin}: {', '.join(done)}")


if __name__ == "__main__":
    main()
