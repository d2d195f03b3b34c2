#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Makes and checks the Unity package: com.langevin.rigid with the C# binding, native libraries and the baker.

    package.py [--native PREFIX...] --out DIR [--tgz]

PREFIX   an installed package of the library (include/, lib/ or bin/, bin/lr_bake), one for each platform, which is read from the
library itself. An archive liblangevin_rigid.a of WebAssembly objects (Emscripten) is for WebGL. Default: the last build here,
by ./demo.sh or with the release preset.
--out    receives com.langevin.rigid, in place of an earlier one.
--tgz    also writes com.langevin.rigid-VERSION.tgz, for "Install package from tarball".
"""
import argparse
import gzip
import json
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tarfile

import metas
import scene

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "packaging"))
import addresses  # noqa: E402
from bundle_libraries import PackageError, built_prefix, copy_elf, licence_of  # noqa: E402

SOURCE = HERE / "com.langevin.rigid"
BINDING = HERE.parent / "csharp" / "src"
ASSETS = HERE.parents[1] / "assets"
HEADER = HERE.parents[1] / "include" / "langevin_rigid.h"
NAME = "com.langevin.rigid"

ELF_MACHINES = {62: "Linux/x86_64", 183: "Linux/arm64"}
MACHO_UNIVERSAL = b"\xca\xfe\xba\xbe"
TOOLS = {"Linux/x86_64": "linux-x64", "Linux/arm64": "linux-arm64", "Windows/x86_64": "windows-x64"}


def elf_platform(path):
    with open(path, "rb") as file:
        head = file.read(20)
    if head[:4] != b"\x7fELF" or head[4] != 2:
        raise PackageError(f"{path}: not a 64-bit ELF library")
    machine = struct.unpack_from("<H", head, 18)[0]
    if machine not in ELF_MACHINES:
        raise PackageError(f"{path}: for a processor that no folder is for (ELF machine {machine})")
    return ELF_MACHINES[machine]


def pe_platform(path):
    data = path.read_bytes()
    at = struct.unpack_from("<I", data, 0x3C)[0] if data[:2] == b"MZ" else 0
    if not at or data[at:at + 4] != b"PE\0\0":
        raise PackageError(f"{path}: not a Windows library")
    if struct.unpack_from("<H", data, at + 4)[0] != 0x8664:
        raise PackageError(f"{path}: not for x86-64")
    return "Windows/x86_64"


def macho_platform(path):
    if path.read_bytes()[:4] != MACHO_UNIVERSAL:
        raise PackageError(f"{path}: not a library for both of macOS's processors")
    return "macOS"


def archive_platform(path):
    data = path.read_bytes()
    if data[:8] != b"!<arch>\n" or b"\0asm" not in data:
        raise PackageError(f"{path}: not an archive of WebAssembly objects")
    return "WebGL"


def library_of(prefix):
    """(platform, path) of the runtime library in a prefix."""
    candidates = [("lib/liblangevin_rigid.so", elf_platform), ("bin/langevin_rigid.dll", pe_platform), ("bin/liblangevin_rigid.dll", pe_platform),
                  ("lib/langevin_rigid.dll", pe_platform), ("lib/liblangevin_rigid.dylib", macho_platform),
                  ("lib/liblangevin_rigid.a", archive_platform)]
    for name, platform in candidates:
        path = prefix / name
        if path.exists():
            return platform(path), path
    raise PackageError(f"{prefix}: none of {', '.join(name for name, _ in candidates)}")


def write_notices(licences, package):
    lines = ["Third party notices", "===================", "", "The native libraries and the baker in this package contain, or come with:", ""]
    lines += [f"- {name}" for name in sorted(licences)]
    for name, text in sorted(licences.items()):
        lines += ["", name, "-" * len(name), "", text.rstrip()]
    (package / "Third Party Notices.md").write_text("\n".join(lines) + "\n")


def put_native(prefix, package, licences):
    platform, library = library_of(prefix)
    folder = package / "Runtime" / "Plugins" / platform
    if folder.exists():
        raise PackageError(f"{prefix}: a library for {platform} is there already")
    names = {"WebGL": "liblangevin_rigid.a", "macOS": "liblangevin_rigid.dylib", "Windows/x86_64": "langevin_rigid.dll"}
    if platform.startswith("Linux"):
        copied, found = copy_elf(library, folder, "liblangevin_rigid.so", as_plugin=True)
        licences.update(licence_of(path, prefix) for path in found)
    else:
        folder.mkdir(parents=True)
        shutil.copyfile(library, folder / names[platform])
        copied = [names[platform]]
        if platform == "Windows/x86_64":
            for beside in sorted(library.parent.glob("*.dll")):
                if beside != library:
                    shutil.copyfile(beside, folder / beside.name)
                    copied.append(beside.name)
                    try:
                        licences.update([licence_of(beside, prefix)])
                    except PackageError as error:
                        print(f"package: warning: {error}")
    for document in (prefix / "licences").glob("*.txt"): # in a package: licences of code in the library
        licences[document.stem] = document.read_text(errors="replace")
    print(f"package: {platform}: {', '.join(copied)}")
    put_tool(prefix, platform, package, licences)


def put_tool(prefix, platform, package, licences):
    if platform not in TOOLS:
        return
    suffix = ".exe" if platform.startswith("Windows") else ""
    tool = prefix / "bin" / f"lr_bake{suffix}"
    if not tool.exists():
        print(f"package: {platform}: no lr_bake in {prefix}: the bake window will look for it on PATH")
        return
    folder = package / "Tools~" / TOOLS[platform]
    if platform.startswith("Linux"):
        _, found = copy_elf(tool, folder, "lr_bake")
        licences.update(licence_of(path, prefix) for path in found)
    else:
        folder.mkdir(parents=True)
        shutil.copyfile(tool, folder / tool.name)
        for beside in sorted(tool.parent.glob("*.dll")):
            shutil.copyfile(beside, folder / beside.name)


def put_sample(prefixes, package):
    """Bakes the storm's leaf, as Unity imports it."""
    folder = package / "Samples~" / "LeafStorm"
    shutil.copyfile(ASSETS / "leaf.obj", folder / "leaf.obj")
    baked = [p / "assets" / "leaf.lrb" for p in prefixes if (p / "assets" / "leaf.lrb").exists()]
    bakers = [p / "bin" / "lr_bake" for p in prefixes if (p / "bin" / "lr_bake").exists() and elf_platform(p / "bin" / "lr_bake") == host_platform()]
    if baked: # the package is for another machine, so its baker does not run here
        shutil.copyfile(baked[0], folder / "leaf.lrb")
    elif bakers:
        subprocess.run([bakers[0], "mesh", folder / "leaf.obj", "-o", folder / "leaf.lrb", "--density", "350", "--name", "leaf", "--quiet"], check=True)
    else:
        raise PackageError("none of the prefixes has assets/leaf.lrb, or an lr_bake that runs here: the sample's leaf cannot be baked")
    importer = metas.guid("Editor/LrbImporter.cs")
    for name in ("leaf.lrb", "LeafStorm.cs"):
        text = metas.meta(f"Samples~/LeafStorm/{name}", False)
        if name == "leaf.lrb":
            # meshMirror 1: Unity's model importer negates x of the OBJ.
            text = text.split("DefaultImporter:")[0] + (
                "ScriptedImporter:\n  internalIDToNameTable: []\n  externalObjects: {}\n  serializedVersion: 2\n" + metas.TAIL +
                f"  script: {{fileID: 11500000, guid: {importer}, type: 3}}\n  meshMirror: 1\n")
        (folder / f"{name}.meta").write_text(text)
    scene.write(folder)


def header_version(header):
    text = header.read_text()
    return ".".join(re.search(rf"#define LR_VERSION_{part} (\d+)", text).group(1) for part in ("MAJOR", "MINOR", "PATCH"))


def library_version(path):
    """The version of a library that this machine can load; otherwise None."""
    code = ("import ctypes, sys; v = ctypes.CDLL(sys.argv[1]).lr_version; v.restype = ctypes.c_uint32; n = v(); "
            "print(f'{n >> 22}.{n >> 12 & 0x3ff}.{n & 0xfff}')")
    run = subprocess.run([sys.executable, "-c", code, path], capture_output=True, text=True)
    return run.stdout.strip() if run.returncode == 0 else None


def check_json(package):
    faults, found = [], {}
    for path in [package / "package.json", *sorted(package.rglob("*.asmdef"))]:
        try:
            found[path] = json.loads(path.read_text())
        except json.JSONDecodeError as error:
            faults.append(f"{path.relative_to(package)}: {error}")
    return faults, found


# Optional or part of the engine: Unity ignores references to assemblies that do not exist.
OUTSIDE = {"Unity.Burst", "UnityEngine.TestRunner", "UnityEditor.TestRunner"}


def check(package):
    """All problems of a package."""
    faults, documents = check_json(package)
    faults += metas.check(package) + scene.check(package)
    definitions = {path: json for path, json in documents.items() if path.suffix == ".asmdef"}
    names = [definition.get("name") for definition in definitions.values()]
    for path, definition in definitions.items():
        where = path.relative_to(package)
        if definition.get("name") != path.stem:
            faults.append(f"{where}: named {definition.get('name')}")
        if names.count(definition.get("name")) > 1:
            faults.append(f"{where}: another assembly has its name")
        faults += [f"{where}: no assembly {name}" for name in definition.get("references", []) if name not in names and name not in OUTSIDE]
        if not any(entry.suffix == ".cs" for entry in path.parent.rglob("*.cs")):
            faults.append(f"{where}: an assembly without sources")
    manifest = documents.get(package / "package.json", {})
    if manifest.get("name") != NAME:
        faults.append(f"package.json: name {manifest.get('name')}")
    version = header_version(HEADER)
    if manifest.get("version") != version:
        faults.append(f"package.json: version {manifest.get('version')}, the header's is {version}")
    if f"## [{version}]" not in (package / "CHANGELOG.md").read_text():
        faults.append(f"CHANGELOG.md: nothing about {version}")
    for sample in manifest.get("samples", []):
        if not (package / sample["path"]).is_dir():
            faults.append(f"package.json: no folder {sample['path']}")
    if not (package / "Third Party Notices.md").exists():
        faults.append("Third Party Notices.md: missing")
    libraries = [path for path in sorted((package / "Runtime" / "Plugins").rglob("*")) if path.name in
                 ("liblangevin_rigid.so", "langevin_rigid.dll", "liblangevin_rigid.dylib", "liblangevin_rigid.a")]
    if not libraries:
        faults.append("Runtime/Plugins: no native library")
    for library in libraries:
        found = library_version(library) if library.suffix == ".so" and elf_platform(library) == host_platform() else None
        if found is not None and found != version:
            faults.append(f"{library.relative_to(package)}: version {found}, the package's is {version}")
        if found is None and library.suffix == ".so" and elf_platform(library) == host_platform():
            faults.append(f"{library.relative_to(package)}: cannot be loaded")
    return faults


def host_platform():
    return {"x86_64": "Linux/x86_64", "aarch64": "Linux/arm64"}.get(os.uname().machine)


def build(prefixes, out):
    package = out / NAME
    if package.exists():
        shutil.rmtree(package)
    shutil.copytree(SOURCE, package)
    shutil.copytree(BINDING, package / "Runtime" / "Bindings", dirs_exist_ok=True)
    licences = {}
    for prefix in prefixes:
        put_native(prefix, package, licences)
    write_notices(licences, package)
    put_sample(prefixes, package)
    addresses.write(package / "package.json")
    metas.write(package)
    faults = check(package)
    if faults:
        raise PackageError("the package is not good:\n  " + "\n  ".join(faults))
    return package


def write_tgz(package, out):
    version = json.loads((package / "package.json").read_text())["version"]
    path = out / f"{NAME}-{version}.tgz"

    def plain(entry):
        entry.uid = entry.gid = entry.mtime = 0
        entry.uname = entry.gname = ""
        return entry

    # No times, owners and file name, so that the archive has the same bits each time.
    with open(path, "wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as packed, tarfile.open(fileobj=packed, mode="w") as archive:
        # npm's layout: Unity's Package Manager expects everything in a folder of this name.
        archive.add(package, "package", filter=plain)
    return path


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--native", action="append", type=pathlib.Path, metavar="PREFIX")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--tgz", action="store_true")
    arguments = parser.parse_args()
    try:
        package = build(arguments.native or [built_prefix(HERE.parents[1])], arguments.out)
        print(f"package: {package} is good")
        if arguments.tgz:
            print(f"package: {write_tgz(package, arguments.out)}")
    except (PackageError, OSError, ValueError, subprocess.CalledProcessError) as error:
        sys.exit(f"package: {error}")


if __name__ == "__main__":
    main()
