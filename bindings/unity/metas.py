#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes and checks the .meta files of a Unity package.

    metas.py write DIR    writes missing or different files, and removes those of missing assets
    metas.py check DIR    prints problems; exit code 1 if there are any

A GUID is the UUID (version 5) of the asset's path in the package. It is the same in every build, so that scenes keep their
references in a new version. A moved file would get a new GUID: list its old path in MOVED.
"""
import pathlib
import re
import sys
import uuid

NAMESPACE = uuid.UUID("5b1c6f0e-6a0f-5d0c-9a53-3c1f6f1f5a11")
MOVED = {}  # new path: path that gives its GUID

TAIL = "  userData: \n  assetBundleName: \n  assetBundleVariant: \n"


def guid(path):
    return uuid.uuid5(NAMESPACE, "com.langevin.rigid/" + MOVED.get(path, path)).hex


def importer(name, body=""):
    return f"{name}:\n  externalObjects: {{}}\n{body}{TAIL}"


def platform(first, second, enabled, settings):
    lines = [f"  - first:\n      {first}: {second}\n    second:\n      enabled: {enabled}\n"]
    if not settings:
        return lines[0] + "      settings: {}\n"
    lines.append("      settings:\n")
    lines += [f"        {key}: {value}\n" for key, value in settings]
    return "".join(lines)


# Folder of a native library: its platform. The other libraries in it (its dependencies) have the same settings.
PLUGINS = {
    "Linux/x86_64": {"Editor": ("x86_64", "Linux"), "Linux64": "x86_64"},
    "Linux/arm64": {"EmbeddedLinux": "ARM64"},
    "Windows/x86_64": {"Editor": ("x86_64", "Windows"), "Win64": "x86_64"},
    "macOS": {"Editor": ("AnyCPU", "OSX"), "OSXUniversal": "AnyCPU"},
    "WebGL": {"WebGL": ""},
}


def plugin(path):
    """Importer settings of a library in Runtime/Plugins."""
    folder = path.split("Runtime/Plugins/", 1)[1].rsplit("/", 1)[0]
    on = PLUGINS[folder]
    excluded = [(f"Exclude {name}", 0 if name in on else 1)
                for name in ("Editor", "EmbeddedLinux", "Linux64", "OSXUniversal", "WebGL", "Win", "Win64")]
    cpu, system = on.get("Editor", ("AnyCPU", "AnyOS"))
    body = platform("", "Any", 0, excluded)
    body += platform("Any", "", 0, [])
    body += platform("Editor", "Editor", int("Editor" in on),
                     [("CPU", cpu), ("DefaultValueInitialized", "true"), ("OS", system)])
    body += platform("EmbeddedLinux", "EmbeddedLinux", int("EmbeddedLinux" in on), [("CPU", on.get("EmbeddedLinux", "AnyCPU"))])
    for name in ("Linux64", "OSXUniversal", "Win", "Win64"):
        body += platform("Standalone", name, int(name in on), [("CPU", on.get(name, "None"))])
    body += platform("WebGL", "WebGL", int("WebGL" in on), [])
    return ("PluginImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  iconMap: {}\n  executionOrder: {}\n  defineConstraints: []\n"
            "  isPreloaded: 0\n  isOverridable: 0\n  isExplicitlyReferenced: 0\n  validateReferences: 1\n  platformData:\n" + body + TAIL)


def is_library(path):
    return re.search(r"\.(dll|a|so|dylib)$", path) is not None


def importer_of(path, is_folder):
    if is_folder:
        return f"folderAsset: yes\n{importer('DefaultImporter')}"
    suffix = pathlib.PurePosixPath(path).suffix
    if path.startswith("Runtime/Plugins/") and is_library(path):
        return plugin(path)
    if suffix == ".cs":
        return ("MonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n"
                "  icon: {instanceID: 0}\n" + TAIL)
    if suffix == ".asmdef":
        return importer("AssemblyDefinitionImporter")
    if path == "package.json":
        return importer("PackageManifestImporter")
    if suffix in (".md", ".txt", ".json"):
        return importer("TextScriptImporter")
    return importer("DefaultImporter")


def meta(path, is_folder):
    return f"fileFormatVersion: 2\nguid: {guid(path)}\n{importer_of(path, is_folder)}"


def hidden(relative):
    """Unity ignores names, of files or folders, that end with ~ or begin with a dot."""
    return any(part.endswith("~") or part.startswith(".") for part in relative.parts)


def assets(root):
    for entry in sorted(root.rglob("*")):
        relative = entry.relative_to(root)
        if not hidden(relative) and entry.suffix != ".meta":
            yield entry, relative.as_posix()


def write(root):
    written = 0
    for entry, path in assets(root):
        at, text = entry.with_name(entry.name + ".meta"), meta(path, entry.is_dir())
        if not at.exists() or at.read_text() != text:
            at.write_text(text)
            written += 1
    for orphan in orphans(root):
        (root / orphan).unlink()
        written += 1
    return written


def orphans(root):
    return [at.relative_to(root).as_posix() for at in sorted(root.rglob("*.meta"))
            if not hidden(at.relative_to(root)) and not at.with_name(at.name[:-5]).exists()]


def check(root):
    """All problems of the metas."""
    faults, seen = [], {}
    for entry, path in assets(root):
        at = entry.with_name(entry.name + ".meta")
        if not at.exists():
            faults.append(f"{path}: no .meta")
            continue
        text = at.read_text()
        found = re.search(r"^guid: ([0-9a-f]{32})$", text, re.M)
        if not found:
            faults.append(f"{path}.meta: no GUID of 32 hexadecimal digits")
            continue
        if found.group(1) in seen:
            faults.append(f"{path}.meta: the GUID of {seen[found.group(1)]}")
        seen[found.group(1)] = path
        if text != meta(path, entry.is_dir()):
            faults.append(f"{path}.meta: not what metas.py writes")
    faults += [f"{orphan}: belongs to nothing" for orphan in orphans(root)]
    return faults


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("write", "check"):
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[2])
    if sys.argv[1] == "write":
        print(f"metas: {write(root)} written or removed")
        return
    faults = check(root)
    for fault in faults:
        print(f"metas: {fault}", file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
