#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts an ELF file into a folder together with the libraries it needs that not every system has, so that they find each other there.

    bundle_libraries.py PREFIX/lib/FILE FOLDER NAME    the licences of those libraries too

For packages of engines, and the wheel, made of a library that was built with the system's Highway and assimp. One that was built with
LR_SELF_CONTAINED needs nothing beside it.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

# What every desktop has, or what a C++ program needs anyway: not put beside the library.
SYSTEM = re.compile(r"^(libc|libm|libpthread|libdl|librt|libutil|libstdc\+\+|libgcc_s|ld-linux.*)\.so(\.\d+)*$")


class PackageError(Exception):
    pass


def needed(path):
    out = subprocess.run(["readelf", "-d", path], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\(NEEDED\).*\[(.+)\]", out)


def find_needed(name, beside, reader, also):
    """Where a library lies that another one needs: given, in its folder, else where the system's loader finds it."""
    for path in [*also, beside / name]:
        if path.name == name and path.exists():
            return path
    found = subprocess.run(["ldd", reader], capture_output=True, text=True).stdout
    match = re.search(rf"^\s*{re.escape(name)} => (/\S+)", found, re.M)
    return pathlib.Path(match.group(1)) if match else None


def copy_elf(source, folder, name, as_plugin=False, also=()):
    """Copies an ELF file and the libraries it needs. Returns the names in the folder, and where the libraries came from.

    as_plugin: libfoo.so.1 becomes libfoo.so, for Unity takes only files whose names end with .so for plug-ins, and leaves others out of
    builds.
    """
    folder.mkdir(parents=True, exist_ok=True)
    names = {}  # name that is asked for: name that it has here
    copied, origins = [name], []
    shutil.copyfile(source.resolve(), folder / name)
    waiting = [source.resolve()]
    while waiting:
        reader = waiting.pop()
        for need in needed(reader):
            if SYSTEM.match(need) or need in names:
                continue
            at = find_needed(need, source.parent, reader, also)
            if at is None:
                raise PackageError(f"{source} needs {need}, which is neither beside it nor on this system: machines without it could not "
                                   "load the package. Put it beside the library, or build that with -DLR_SELF_CONTAINED=ON "
                                   "(packaging/build_library.sh), which carries it inside")
            names[need] = re.sub(r"\.so\..*$", ".so", need) if as_plugin else need
            shutil.copyfile(at.resolve(), folder / names[need])
            copied.append(names[need])
            origins.append(at)
            waiting.append(at.resolve())
    for file in copied:
        os.chmod(folder / file, 0o755)
    if names:
        if shutil.which("patchelf") is None:
            raise PackageError("patchelf is missing (apt-get install patchelf): libraries beside each other would not be found")
        # One change a run: older versions of patchelf mix up the arguments of several.
        changes = [["--set-rpath", "$ORIGIN"]] + [["--replace-needed", old, new] for old, new in names.items() if old != new]
        for file in copied:
            for change in changes:
                subprocess.run(["patchelf", *change, folder / file], check=True)
        for old, new in names.items():
            if old != new:
                subprocess.run(["patchelf", "--set-soname", new, folder / new], check=True)
    return copied, origins


def licence_of(library, prefix):
    """(name, text) of the licence of a library that was copied: from the prefix's own documents, else from the system's package."""
    name = re.match(r"(lib.*?)(\.so.*|\.dll)$", library.name).group(1)
    for document in sorted((prefix / "share" / "doc").rglob("*")) if (prefix / "share" / "doc").exists() else []:
        if document.is_file() and name.removeprefix("lib") in document.as_posix().lower() and re.search("licen|copyright", document.name, re.I):
            return name, document.read_text(errors="replace")
    owner = subprocess.run(["dpkg-query", "-S", library.resolve()], capture_output=True, text=True).stdout if shutil.which("dpkg-query") else ""
    if not owner:  # /lib is a link to /usr/lib, and only one of both is in the package's list
        owner = subprocess.run(["dpkg-query", "-S", f"*/{library.resolve().name}"], capture_output=True, text=True).stdout
    document = pathlib.Path("/usr/share/doc") / owner.split(":")[0] / "copyright"
    if not owner or not document.exists():
        raise PackageError(f"{library}: no licence found, neither in {prefix}/share/doc nor of a package of this system")
    return name, document.read_text(errors="replace")


def built_prefix(root):
    """Installs what was built last, by ./demo.sh or with the release preset, and returns the prefix."""
    libraries = [path for path in (root / "build" / name / "src" / "liblangevin_rigid.so" for name in ("demo", "release")) if path.exists()]
    if not libraries:
        raise PackageError("no library in build/demo or build/release: run ./demo.sh, or name an installed one by --native PREFIX")
    build = max(libraries, key=lambda path: path.stat().st_mtime).parents[1]
    prefix = root / "build" / "prefix"
    for component in ("runtime", "bake"):
        installed = subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", component], capture_output=True, text=True)
        if installed.returncode != 0:
            raise PackageError(f"{build} is not whole, build it first (cmake --build {build}):\n{installed.stderr.strip()}")
    return prefix


if __name__ == "__main__":
    try:
        file, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
        for origin in copy_elf(file, folder, sys.argv[3])[1]:
            title, text = licence_of(origin, file.parents[1])
            (folder / f"{title}.licence.txt").write_text(text)
    except PackageError as error:
        sys.exit(f"bundle_libraries.py: {error}")
