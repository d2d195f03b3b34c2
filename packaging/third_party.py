#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes THIRD_PARTY.md and licences/ of a package: the bundled third-party software and its terms.

    third_party.py --platform linux-x64 --sources build/sources --out STAGE
"""
import argparse
import re
import subprocess
import sys
from pathlib import Path

COMMON = Path("/usr/share/common-licenses")
RUNTIME, BAKER, BOTH = "library", "lr_bake", "library, lr_bake"

# Name, bundled part and terms, file that contains it, Debian source ("source:") or package.
CARRIED = [
    ("Highway", "SIMD; Apache-2.0", BOTH, "source:highway"),
    ("FlatBuffers", "headers of the asset format; Apache-2.0", BOTH, "libflatbuffers-dev"),
    ("assimp", "readers of STL, glTF, FBX and Collada, with pugixml, RapidJSON and openddlparser; BSD-3-Clause, MIT", BAKER,
     "source:assimp"),
    ("Draco", "decoder of compressed glTF; Apache-2.0", BAKER, "source:draco"),
    ("libpng", "images of cards; libpng-2.0", BAKER, "source:libpng1.6"),
    ("zlib", "with minizip; Zlib", BAKER, "source:zlib"),
    ("UTF8-CPP", "headers; BSL-1.0", BAKER, "libutfcpp-dev"),
    ("Eigen", "headers; MPL-2.0, its sources are Debian's eigen3, unchanged", BAKER, "libeigen3-dev"),
    ("Boost", "headers; BSL-1.0", BAKER, "libboost1.74-dev"),
    ("CLI11", "headers; BSD-3-Clause", BAKER, "libcli11-dev"),
    ("JSON for Modern C++", "headers; MIT", BAKER, "nlohmann-json3-dev"),
]
COMPILER = {
    "source": [],  # only what the runtime contains
    "engines": [("GCC runtime", "libstdc++ and libgcc; GPL-3.0 with the GCC Runtime Library Exception", RUNTIME, "gcc-12-base"),
                ("MinGW-w64", "start-up code, winpthreads, parts of the C library; ZPL-2.1, MIT, public domain", RUNTIME, "mingw-w64-common")],
    "linux-x64": [("GCC runtime", "libstdc++ and libgcc; GPL-3.0 with the GCC Runtime Library Exception", BOTH, "gcc-12-base")],
    "linux-arm64": [("GCC runtime", "libstdc++ and libgcc; GPL-3.0 with the GCC Runtime Library Exception", BOTH,
                     "gcc-12-cross-base|gcc-12-base")],
    "windows-x64": [
        ("GCC runtime", "libstdc++ and libgcc; GPL-3.0 with the GCC Runtime Library Exception", BOTH, "gcc-mingw-w64-base"),
        ("MinGW-w64", "start-up code, winpthreads, parts of the C library; ZPL-2.1, MIT, public domain", BOTH, "mingw-w64-common"),
    ],
}


def version_of_package(name: str) -> str:
    return subprocess.run(["dpkg-query", "-W", "-f=${Version}", name], check=True, capture_output=True, text=True).stdout


def find(entry: str, sources: Path, versions: dict) -> tuple[str, str, Path]:
    """Debian's name, the version, and the file with the terms."""
    if entry.startswith("source:"):
        name = entry.removeprefix("source:")
        return name, versions[name], sources / name / "debian" / "copyright"
    for name in entry.split("|"):
        path = Path("/usr/share/doc") / name / "copyright"
        if path.is_file():
            return name, version_of_package(name), path
    sys.exit(f"third_party.py: no copyright file of {entry}: scripts/setup.sh package")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--platform", required=True, choices=sorted(COMPILER))
    parser.add_argument("--sources", required=True, type=Path)
    parser.add_argument("--out", required=True, type=Path)
    options = parser.parse_args()

    versions = dict(line.split() for line in (options.sources / "versions").read_text().splitlines())
    folder = options.out / "licences"
    folder.mkdir(parents=True, exist_ok=True)
    rows, common = [], set()
    for name, what, where, entry in CARRIED + COMPILER[options.platform]:
        if options.platform in ("source", "engines") and where == BAKER:
            continue
        debian, version, terms = find(entry, options.sources, versions)
        text = terms.read_bytes().decode("utf-8", errors="replace")
        target = folder / (re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-") + ".txt")
        target.write_text(text, encoding="utf-8")
        common.update(match.rstrip(".") for match in re.findall(r"/usr/share/common-licenses/([\w.-]+)", text))
        rows.append(f"| {name} | {version} | {what} | {where} | `licences/{target.name}` | {debian} |")
    for licence in sorted(common):
        (folder / f"{licence}.txt").write_bytes((COMMON / licence).resolve().read_bytes())

    lines = [
        "# Third-party software in this package", "",
        "Langevin Rigid itself is under the MIT licence (`LICENSE`). Its files contain parts of the following, built from Debian's sources with",
        "Debian's patches. The versions are Debian's.", "",
        "| name | version | bundled part; terms | contained in | full terms | Debian's name |",
        "|---|---|---|---|---|---|", *rows, "",
        "The terms are those that Debian collected for all files of a source, bundled or not. Licences that they call",
        "`/usr/share/common-licenses/NAME` are in `licences/NAME.txt`. The sources of these versions are at",
        "https://snapshot.debian.org under their Debian name (`apt-get source NAME`).", ""]
    (options.out / "THIRD_PARTY.md").write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
