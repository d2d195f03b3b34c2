#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Copies an ELF file and its non-system libraries into a folder, and sets their run paths to that folder.

    bundle_libraries.py PREFIX/lib/FILE FOLDER NAME    also writes the licences of the libraries

For engine packages and the wheel, if the library was built with the system's Highway and assimp. A library built with
LR_SELF_CONTAINED needs no others.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Not copied: libraries that every desktop or C++ program has.
SYSTEM = re.compile(r"^(libc|libm|libpthread|libdl|librt|libutil|libstdc\+\+|libgcc_s|ld-linux.*)\.so(\.\d+)*$")


class PackageError(Exception):
    pass


def needed(path):
    out = subprocess.run(["readelf", "-d", path], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\(NEEDED\).*\[(.+)\]", out)


def find_needed(name, beside, reader, also):
    """The path of a needed library: from `also`, in the folder `beside`, or from the system's loader."""
    for path in [*also, beside / name]:
        if path.name == name and path.exists():
            return path
    found = subprocess.run(["ldd", reader], capture_output=True, text=True).stdout
    match = re.search(rf"^\s*{re.escape(name)} => (/\S+)", found, re.M)
    return pathlib.Path(match.group(1)) if match else None


def copy_elf(source, folder, name, as_plugin=False, also=()):
    """Copies an ELF file and the libraries it needs. Returns the names in the folder and the libraries' original paths.

    as_plugin: libfoo.so.1 becomes libfoo.so, because Unity treats only files whose names end with .so as plug-ins and omits others from
    builds.
    """
    folder.mkdir(parents=True, exist_ok=True)
    names = {}  # needed name: name in the folder
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
                                   "load the package. Put it beside the library, or build the library with -DLR_SELF_CONTAINED=ON "
                                   "(packaging/build_library.sh), which links it statically")
            names[need] = re.sub(r"\.so\..*$", ".so", need) if as_plugin else need
            shutil.copyfile(at.resolve(), folder / names[need])
            copied.append(names[need])
            origins.append(at)
            waiting.append(at.resolve())
    for file in copied:
        os.chmod(folder / file, 0o755)
    if names:
        if shutil.which("patchelf") is None:
            raise PackageError("patchelf is missing (apt-get install patchelf): it sets the run paths of the libraries")
        # One change per run: older versions of patchelf confuse the arguments of several.
        changes = [["--set-rpath", "$ORIGIN"]] + [["--replace-needed", old, new] for old, new in names.items() if old != new]
        for file in copied:
            for change in changes:
                subprocess.run(["patchelf", *change, folder / file], check=True)
        for old, new in names.items():
            if old != new:
                subprocess.run(["patchelf", "--set-soname", new, folder / new], check=True)
    return copied, origins


def licence_of(library, prefix):
    """(name, text) of the licence of a copied library, from the prefix's documents or the system's package."""
    name = re.match(r"(lib.*?)(\.so.*|\.dll)$", library.name).group(1)
    for document in sorted((prefix / "share" / "doc").rglob("*")) if (prefix / "share" / "doc").exists() else []:
        if document.is_file() and name.removeprefix("lib") in document.as_posix().lower() and re.search("licen|copyright", document.name, re.I):
            return name, document.read_text(errors="replace")
    owner = subprocess.run(["dpkg-query", "-S", library.resolve()], capture_output=True, text=True).stdout if shutil.which("dpkg-query") else ""
    if not owner:  # /lib is a link to /usr/lib, and the package lists only one of them
        owner = subprocess.run(["dpkg-query", "-S", f"*/{library.resolve().name}"], capture_output=True, text=True).stdout
    document = pathlib.Path("/usr/share/doc") / owner.split(":")[0] / "copyright"
    if not owner or not document.exists():
        raise PackageError(f"{library}: no licence found in {prefix}/share/doc or the packages of this system")
    return name, document.read_text(errors="replace")


def built_prefix(root):
    """Installs the newer build of ./demo.sh and the release preset; returns the prefix."""
    libraries = [path for path in (root / "build" / name / "src" / "liblangevin_rigid.so" for name in ("demo", "release")) if path.exists()]
    if not libraries:
        raise PackageError("no library in build/demo or build/release: run ./demo.sh, or name an installed one by --native PREFIX")
    build = max(libraries, key=lambda path: path.stat().st_mtime).parents[1]
    prefix = root / "build" / "prefix"
    for component in ("runtime", "bake"):
        installed = subprocess.run(["cmake", "--install", build, "--prefix", prefix, "--component", component], capture_output=True, text=True)
        if installed.returncode != 0:
            raise PackageError(f"{build} is incomplete, build it first (cmake --build {build}):\n{installed.stderr.strip()}")
    return prefix


if __name__ == "__main__":
    try:
        file, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
        for origin in copy_elf(file, folder, sys.argv[3])[1]:
            title, text = licence_of(origin, file.parents[1])
            (folder / f"{title}.licence.txt").write_text(text)
    except PackageError as error:
        sys.exit(f"bundle_libraries.py: {error}")
