#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Breaks a good package in many ways, each of which package.check must find.   package_faults.py PACKAGE PREFIX SCRATCH"""
import pathlib
import shutil
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import package  # noqa: E402
import scene  # noqa: E402


def replace(path, old, new):
    text = path.read_text()
    assert old in text, f"{path}: no {old}"
    path.write_text(text.replace(old, new, 1))


def copy_guid(root):
    other = (root / "README.md.meta").read_text().split("guid: ")[1][:32]
    mine = (root / "CHANGELOG.md.meta").read_text().split("guid: ")[1][:32]
    replace(root / "CHANGELOG.md.meta", mine, other)


SAMPLE = pathlib.Path("Samples~/LeafStorm")
CASES = [
    ("no .meta", lambda r: (r / "Editor/LrbImporter.cs.meta").unlink()),
    ("no .meta", lambda r: (r / "Runtime.meta").unlink()),
    ("belongs to nothing", lambda r: (r / "Runtime/LangevinWind.cs").unlink()),
    ("the GUID of", copy_guid),
    ("not what metas.py writes", lambda r: replace(r / "Runtime/Plugins/Linux/x86_64/liblangevin_rigid.so.meta", "CPU: x86_64", "CPU: x86")),
    ("package.json:", lambda r: replace(r / "package.json", "{", "{,")),
    ("version 9.9.9", lambda r: replace(r / "package.json", '"version": "', '"version": "9.9.9", "was": "')),
    ("nothing about", lambda r: replace(r / "CHANGELOG.md", "## [", "## (")),
    ("no assembly LangevinRigid.Wrong", lambda r: replace(r / "Editor/LangevinRigid.Unity.Editor.asmdef", '"LangevinRigid.Unity"]', '"LangevinRigid.Wrong"]')),
    ("named Other", lambda r: replace(r / "Runtime/LangevinRigid.Unity.asmdef", '"name": "LangevinRigid.Unity"', '"name": "Other"')),
    ("another assembly has its name", lambda r: replace(r / "Runtime/Bindings/LangevinRigid.asmdef", '"name": "LangevinRigid"', '"name": "LangevinRigid.Unity"')),
    ("no folder", lambda r: shutil.rmtree(r / "Samples~/LeafStorm")),
    ("has no object 770", lambda r: replace(r / SAMPLE / "LeafStorm.unity", "m_SourcePrefab: {fileID: 100100000", "m_SourcePrefab: {fileID: 770")),
    ("no object 99", lambda r: replace(r / SAMPLE / "LeafStorm.unity", "  ball: {fileID: ", "  ball: {fileID: 99")),
    ("not a component of", lambda r: replace(r / SAMPLE / "Leaves.prefab", "  - component: {fileID: 3}\n", "")),
    ("no file has the GUID", lambda r: (r / SAMPLE / "Leaf.mat.meta").unlink()),
    ("no class of its name", lambda r: replace(r / SAMPLE / "LeafStorm.cs", "class LeafStorm", "class Storm")),
    ("leaf.obj has no object", lambda r: replace(r / SAMPLE / "Leaves.prefab", "mesh: {fileID: -", "mesh: {fileID: ")),
    ("no native library", lambda r: shutil.rmtree(r / "Runtime/Plugins")),
    ("cannot be loaded", lambda r: (r / "Runtime/Plugins/Linux/x86_64/libhwy.so").resolve(strict=True).write_bytes(b"")),
]


def refused(prefix):
    try:
        package.library_of(prefix)
    except package.PackageError:
        return True
    return False


def platforms(scratch):
    """Libraries of other systems, by what their first bytes say; and what Unity is told about each."""
    import metas
    bad = []
    dll = bytearray(256)
    dll[:2] = b"MZ"
    struct.pack_into("<I", dll, 0x3C, 128)
    dll[128:132] = b"PE\0\0"
    for machine, wanted in ((0x8664, "Windows/x86_64"), (0x14C, None)):
        struct.pack_into("<H", dll, 132, machine)
        (scratch / "bin").mkdir(parents=True, exist_ok=True)
        (scratch / "bin/langevin_rigid.dll").write_bytes(dll)
        if (None if refused(scratch) else package.library_of(scratch)[0]) != wanted:
            bad.append(f"a DLL for machine {machine:#x}")
    shutil.rmtree(scratch / "bin")
    (scratch / "lib").mkdir(parents=True)
    for content, wanted in ((b"!<arch>\nx.o/  \0asm", "WebGL"), (b"!<arch>\nx.o/  \x7fELF", None)):
        (scratch / "lib/liblangevin_rigid.a").write_bytes(content)
        if (None if refused(scratch) else package.library_of(scratch)[0]) != wanted:
            bad.append(f"an archive of {content[-4:]}")
    shutil.rmtree(scratch / "lib")
    enabled = {"Linux/x86_64": {"Editor", "Linux64"}, "Linux/arm64": {"EmbeddedLinux"}, "Windows/x86_64": {"Editor", "Win64"}, "macOS": {"Editor", "OSXUniversal"}, "WebGL": {"WebGL"}}
    for folder, wanted in enabled.items():
        blocks = metas.plugin(f"Runtime/Plugins/{folder}/liblangevin_rigid.so").split("  - first:\n")[1:]
        on = {block.split("\n")[0].split(": ")[1] for block in blocks if "enabled: 1" in block}
        if on != wanted:
            bad.append(f"{folder} is enabled for {on}")
    return bad


def main():
    good, prefix, scratch = (pathlib.Path(a) for a in sys.argv[1:4])
    bad = 0
    # IDs that Unity itself gave objects of this type and name: roots of models, shader graphs, input actions.
    root = "//" + "/".join(("RootNode", "root", "Transform"))
    for kind, name, wanted in [("Transform", root, -8679921383154817045), ("Shader", "MainAsset", -6465566751694194690),
                               ("MonoBehaviour", "<root>", -944628639613478452)]:
        if scene.imported_id(kind, name) != wanted:
            bad += 1
            print(f"the fileID of {kind} {name}")
    faults = package.check(good)
    if faults:
        bad += 1
        print("a good package has faults:", *faults, sep="\n  ")
    for wanted, spoil in CASES:
        shutil.rmtree(scratch, ignore_errors=True)
        shutil.copytree(good, scratch, ignore=shutil.ignore_patterns("Tools~"))
        try:
            spoil(scratch)
        except FileNotFoundError:
            if wanted != "cannot be loaded":
                raise
            continue  # a library that needs nothing beside it
        found = package.check(scratch)
        if not any(wanted in fault for fault in found):
            bad += 1
            print(f"not found: {wanted}; found: {found}")
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir()
    if not refused(scratch):
        bad += 1
        print("an empty prefix was taken")
    missed = platforms(scratch)
    bad += len(missed)
    print(*missed, sep="\n")
    (scratch / "lib").mkdir()
    (scratch / "lib/liblangevin_rigid.so").write_bytes(b"\x7fELF\x01" + bytes(40))
    if not refused(scratch):
        bad += 1
        print("a 32-bit library was taken")
    print(f"{len(CASES) + 14} cases, {bad} missed")
    sys.exit(1 if bad else 0)


if __name__ == "__main__":
    main()
