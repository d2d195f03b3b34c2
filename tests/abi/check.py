#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The ABI gate: checks a built library and the header against every released version that they must serve. docs/maintainers/releases.md

    tests/abi/check.py LIBRARY [--header FILE] [--exports FILE] [--baselines DIR]
    tests/abi/check.py --renew VERSION     at a release: freezes the present header as that version's baseline

Growth is reported, breaks are refused, unless the library has another soname than the broken version, so that its programs
cannot load it. Needs abigail-tools and python3-clang-14 (scripts/setup.sh test)."""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import debug_stub
import surface
from surface import api_model

HERE = pathlib.Path(__file__).resolve().parent
HEADER = surface.ROOT / "include" / "langevin_rigid.h"
ABIDW = ["abidw", "--no-corpus-path", "--no-show-locs", "--no-comp-dir-path", "--type-id-style", "hash"]


def run(*command):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)


def read(*command):
    done = run(*command)
    if done.returncode:
        raise SystemExit(f"{' '.join(map(str, command))}: {done.stderr}")
    return done.stdout


def soname_of(library):
    match = re.search(r"SONAME.*\[(.*)\]", read("readelf", "-dW", library))
    return match.group(1) if match else ""


def exported(library, faults):
    """Function names that programs can bind to, under the library's only version."""
    names, nodes = set(), set()
    for line in read("nm", "-D", "--defined-only", "--with-symbol-versions", library).splitlines():
        kind, symbol = line.split()[-2:]
        if kind == "A":
            continue  # the version node itself
        name, at, node = symbol.partition("@")
        if kind != "T":
            faults.append(f"exports: {name} is exported but is no function ({kind}): data have a size that programs copy")
        if not at or not node.startswith("@"):
            faults.append(f"exports: {symbol} is not of the library's version, or is a second one beside it (.symver)")
        nodes.add(node.lstrip("@"))
        names.add(name)
    if len(nodes) > 1:
        faults.append(f"exports: symbols of several versions: {' '.join(sorted(nodes))}")
    return names


def check_exports(library, header_names, allowed_file, faults):
    found = exported(library, faults)
    allowed = set(re.findall(r"^lr_\w+$", pathlib.Path(allowed_file).read_text(), re.M))
    for what, names, other, others in (("exported", found, "in the list", allowed), ("in the list", allowed, "exported", found),
                                       ("declared", header_names, "in the list", allowed),
                                       ("in the list", allowed, "declared", header_names)):
        faults.extend(f"exports: {name} is {what} but not {other}" for name in sorted(names - others))
    return found


def abidiff(baseline, library, header, grown, folder):
    """The differences found by libabigail, except permitted growth of structs. Empty: none."""
    suppressions = folder / "growth.ini"
    suppressions.write_text("".join(f"[suppress_type]\n  type_kind = struct\n  name_regexp = ^{name}$\n  has_size_change = yes\n"
                                    "  has_data_member_inserted_at = end\n" for name in grown))
    typed = folder / "types.abi"
    if ".debug_info" not in read("readelf", "-SW", library):
        library = debug_stub.build(header, folder / "stub", soname_of(library))
    read(*ABIDW, "--headers-dir", pathlib.Path(header).parent, "--out-file", typed, library)
    # The header's check reports added functions.
    done = run("abidiff", "--no-added-syms", "--suppressions", suppressions, baseline / "langevin_rigid.abi", typed)
    if done.returncode & 3:
        raise SystemExit(f"abidiff: {done.stdout}{done.stderr}")
    return done.stdout.strip() if done.returncode else ""


def check(library, header, allowed, baselines):
    """Faults, and notes on growth."""
    faults, notes = [], []
    new = surface.Surface(header)
    found = check_exports(library, set(new.functions), allowed, faults)
    versions = sorted((p.parent for p in pathlib.Path(baselines).glob("*/langevin_rigid.h")),
                      key=lambda p: tuple(map(int, p.name.split("."))))
    if not versions:
        notes.append("no version is frozen yet: exports and header are compared with each other alone")
    for baseline in versions:
        old = surface.Surface(baseline / "langevin_rigid.h")
        breaks, growth = surface.compare(old, new)
        breaks += [f"function {name} is no longer exported" for name in old.functions if name not in found and name in new.functions]
        xml = (baseline / "langevin_rigid.abi").read_text()
        old_soname = re.search(r"soname='([^']*)'", xml).group(1)
        with tempfile.TemporaryDirectory() as folder:
            said = abidiff(baseline, library, header, surface.grown(old, new), pathlib.Path(folder))
        if said:
            breaks.append("libabigail says:\n    " + said.replace("\n", "\n    "))
        if breaks and soname_of(library) != old_soname:
            notes.append(f"breaks {baseline.name}, and may: {soname_of(library)} is not {old_soname}")
            notes += [f"  {text}" for text in breaks]
        else:
            faults += [f"breaks {baseline.name}: {text}" for text in breaks]
        notes += [f"since {baseline.name}: {text}" for text in growth]
        notes.append(f"{baseline.name}: {len(old.functions)} functions, {len(old.structs)} structs, {len(old.constants)} constants")
    return faults, notes


def renew(version, header=HEADER, baselines=HERE):
    """A version's baseline: the header, its types for libabigail, its layout for C."""
    folder = pathlib.Path(baselines) / version
    folder.mkdir(parents=True, exist_ok=True)
    for file in api_model.files_of(header):
        frozen = folder / file.name.replace(pathlib.Path(header).stem, "langevin_rigid")
        shutil.copyfile(file, frozen)
    frozen = folder / "langevin_rigid.h"
    (folder / "layout.txt").write_text(surface.layout_text(surface.Surface(frozen)))
    with tempfile.TemporaryDirectory() as work:
        library = debug_stub.build(frozen, work)
        read(*ABIDW, "--headers-dir", work, "--out-file", folder / "langevin_rigid.abi", library)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("library", nargs="?")
    parser.add_argument("--header", default=HEADER)
    parser.add_argument("--exports", default=surface.ROOT / "tests" / "api" / "exports.txt")
    parser.add_argument("--baselines", default=HERE)
    parser.add_argument("--renew", metavar="VERSION")
    options = parser.parse_args()
    if options.renew:
        renew(options.renew, options.header, options.baselines)
        return 0
    if not options.library:
        parser.error("which library")
    faults, notes = check(options.library, options.header, options.exports, options.baselines)
    for note in notes:
        print(f"abi: {note}")
    for fault in faults:
        print(f"abi: REFUSED: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
