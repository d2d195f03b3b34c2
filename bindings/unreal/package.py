#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Packages the Unreal plugin with native libraries: a folder for a project's Plugins/.

    package.py --native Linux=/opt/langevin_rigid --native Win64=C:/langevin_rigid --out MyProject/Plugins

PREFIX: where the library is installed (include/, lib/, bin/). PLATFORM= is optional; by default it is read from the library.
Default for --native: the last build here, by ./demo.sh or with the release preset. Dependencies are packaged too; --also names one
that is neither beside the library nor on this system (a C++ runtime of another platform).
"""
import argparse
import re
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "packaging")]
import addresses  # noqa: E402
import native_file  # noqa: E402
from bundle_libraries import PackageError, built_prefix, copy_elf, licence_of  # noqa: E402

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
    shutil.copyfile(source, target)  # follows links: plugin folders pass through zip files and version control
    print(f"  {target}")


def put_dlls(library: Path, described: native_file.NativeFile, folder: Path, places: list) -> None:
    for needed in described.needed:
        beside = [p for p in [library.parent / needed, *(d / needed if d.is_dir() else d for d in places)]
                  if p.name.lower() == needed.lower() and p.is_file()
                  and native_file.describe(p).machine == described.machine]
        if beside:
            put(beside[0], folder / beside[0].name)
        elif not native_file.is_system(needed):
            fail(f"{library} needs {needed}, which is not beside it: machines without it could not load the plugin. Give it by --also "
                 "FILE, or build the library with -DLR_SELF_CONTAINED=ON (packaging/build_library.sh), which carries it inside")


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

    for licence in sorted([*(prefix / "share/doc/langevin_rigid").glob("*"), *(prefix / "licences").glob("*")]):
        if licence.is_file():
            put(licence, plugin / "Licenses" / licence.name)

    folder = plugin / THIRD_PARTY / "lib" / platform
    if platform == "Win64":
        put(library, folder / library.name)
        put_dlls(library, described, folder, [prefix / "bin", *also])
        target = folder / "langevin_rigid.lib"
        target.write_bytes(native_file.import_library(library.name, native_file.pe_exports(library)))
        print(f"  {target}")
    else:
        # The linker uses the plain name, the loader the soname.
        name = described.soname or "liblangevin_rigid.so"
        copied, origins = copy_elf(library, folder, name, also=also)
        for file in copied:
            print(f"  {folder / file}")
        if name != "liblangevin_rigid.so":
            put(folder / name, folder / "liblangevin_rigid.so")
        for origin in origins:
            title, text = licence_of(origin, prefix)
            (plugin / "Licenses").mkdir(exist_ok=True)
            (plugin / "Licenses" / f"{title}.txt").write_text(text)
    tool = prefix / "bin" / ("lr_bake.exe" if platform == "Win64" else "lr_bake")
    tools = plugin / THIRD_PARTY / "bin" / platform
    if not tool.is_file():
        print(f"  no {tool}: meshes cannot be baked in the editor on {platform}")
    elif platform == "Win64":
        put(tool, tools / tool.name)
        put_dlls(tool, native_file.describe(tool), tools, [prefix / "bin", *also])
    else:
        _, origins = copy_elf(tool, tools, tool.name, also=also)
        print(f"  {tools / tool.name}")
        for origin in origins:
            title, text = licence_of(origin, prefix)
            (plugin / "Licenses").mkdir(exist_ok=True)
            (plugin / "Licenses" / f"{title}.txt").write_text(text)
    return platform


def write_leaf(plugin: Path) -> None:
    """The sample's leaf, in the engine's unit: importers take an OBJ's numbers for centimetres."""
    lines = [" ".join(["v", *(f"{100.0 * float(x):.6g}" for x in line.split()[1:4])]) if line.startswith("v ") else line
             for line in (HERE.parents[1] / "assets/leaf.obj").read_text().splitlines()]
    (plugin / "Content/Python/leaf.obj").write_text("\n".join(lines) + "\n")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--native", action="append", metavar="[PLATFORM=]PREFIX")
    parser.add_argument("--also", action="append", default=[], type=Path, metavar="FILE")
    parser.add_argument("--engine", metavar="VERSION", help="the engine for which it is packaged, as 5.4.0: shops want it; without it any")
    parser.add_argument("--out", required=True, type=Path, metavar="DIR", help="where LangevinRigid/ is written")
    arguments = parser.parse_args()
    if arguments.engine and not re.fullmatch(r"5\.\d+\.\d+", arguments.engine):
        fail(f"--engine is a version as 5.4.0, not {arguments.engine}")
    plugin = arguments.out / "LangevinRigid"
    if plugin.exists() and not (plugin / "LangevinRigid.uplugin").is_file():
        fail(f"{plugin} exists and is not this plugin")
    shutil.rmtree(plugin, ignore_errors=True)
    shutil.copytree(HERE / "LangevinRigid", plugin,
                    ignore=shutil.ignore_patterns("lib", "include", "Binaries", "Intermediate", "__pycache__"))
    if arguments.engine:
        file = plugin / "LangevinRigid.uplugin"
        text = file.read_text()
        file.write_text(text.replace('\t"FriendlyName"', f'\t"EngineVersion": "{arguments.engine}",\n\t"FriendlyName"', 1))
    try:
        addresses.write(plugin / "LangevinRigid.uplugin")
    except ValueError as error:
        fail(str(error))
    write_leaf(plugin)
    licence = HERE.parents[1] / "LICENSE"
    if licence.is_file():
        shutil.copyfile(licence, plugin / "LICENSE")
    try:
        natives = arguments.native or [str(built_prefix(HERE.parents[1]))]
        done = [package_native(plugin, native, arguments.also) for native in natives]
    except PackageError as error:
        fail(str(error))
    if len(set(done)) != len(done):
        fail("two of --native are for the same platform")
    print(f"{plugin}: {', '.join(done)}")


if __name__ == "__main__":
    main()
