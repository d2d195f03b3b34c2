#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes README.md of a package with measurements of its files, and the same numbers into the table of docs/maintainers/releases.md.

    package_readme.py --platform linux-x64 --version 0.2.0 --stage STAGE --docs docs/maintainers/releases.md
        [--library-floor 2.17 --baker-floor 2.30]
"""
import argparse
import re
import sys
from pathlib import Path

NAMES = {"linux-x64": "Linux on x86-64", "linux-arm64": "Linux on 64-bit ARM", "windows-x64": "Windows 10 or later on x86-64"}
PROCESSOR = {"linux-arm64": ""}
PROCESSOR["linux-x64"] = PROCESSOR["windows-x64"] = " The processor needs SSE4.2 and AES (2010 and later); AVX2 and AVX-512 are used if present."
LIBRARY = {"windows-x64": "bin/langevin_rigid.dll"}
BEGIN, END = "<!-- measured by scripts/package.sh -->", "<!-- end -->"


def floor_of_linux(options) -> str:
    return (f"The library needs glibc {options.library_floor} or later and nothing else; lr_bake needs glibc {options.baker_floor} or later. "
            "Both were measured from the symbol versions that the files require." + PROCESSOR[options.platform])


def read_me(options) -> str:
    windows = options.platform.startswith("windows")
    exe = ".exe" if windows else ""
    library = LIBRARY.get(options.platform, "lib/liblangevin_rigid.so")
    needs = ("It needs Windows' own DLLs and nothing else." + PROCESSOR[options.platform]
             if windows else floor_of_linux(options))
    cc = (r"cl /std:c11 /I include samples\hello.c lib\langevin_rigid.lib" "\n"
          "    gcc -Iinclude samples/hello.c -Llib -llangevin_rigid -o hello.exe" if windows else
          "cc -std=c99 -Iinclude samples/hello.c -Llib -llangevin_rigid -Wl,-rpath,$PWD/lib -o hello && ./hello")
    run = ("Put `langevin_rigid.dll` beside the program, or in a folder of PATH."
           if windows else "Ship `liblangevin_rigid.so.0` beside your program and link that with `-Wl,-rpath,'$ORIGIN'`.")
    rows = [("include/langevin_rigid.h", "the API: units, ownership, errors and threads of every function"),
            ("include/langevin_rigid.hpp", "the same for C++17: worlds and assets that destroy themselves, exceptions"),
            ("include/langevin_rigid_research.h", "bodies from given matrices, coefficients of the loads, turbulence tables"),
            (library, "the library; it exports the functions of these headers and nothing else")]
    if windows:
        rows += [("lib/langevin_rigid.lib", "import library for Microsoft's linker and LLVM's"),
                 ("lib/liblangevin_rigid.dll.a", "import library for MinGW"),
                 ("lib/langevin_rigid.def", "its exports, for other linkers")]
    rows += [("lib/liblangevin_rigid_static.a", "the library for linking in, " + (
        "by MinGW's GCC, with `-l:libstdc++.a -l:libwinpthread.a`" if windows else "with glibc 2.36 or later: it contains its C++ runtime, and no name but the API's is global")
        + "; define `LR_STATIC`, or use `langevin_rigid::static` in CMake"),
             ("lib/cmake, lib/pkgconfig", "for CMake and pkg-config; the folder may be moved anywhere"),
             (f"bin/lr_bake{exe}", "makes assets from meshes and leaf textures"),
             (f"bin/lr_drop{exe}", "drops an asset: how fast and in which manner it falls, with a picture"),
             (f"bin/lr_replay{exe}", "replays a recording of a world's calls (`lr_world_record_start`) and compares every bit"),
             ("assets", "baked meshes (.lrb) and their sources (.obj)"),
             ("samples", "the first falling bodies in C; leaves, a dart, confetti, a coin and a car in twenty lines of C++ each"),
             ("bindings/csharp", "the API in C#: `docs/guide/languages.md`. Engines, Python, Blender and the web have packages of their own"),
             ("LICENSE, THIRD_PARTY.md, licences", "licences of this library and of the software inside"),
             ("SHA256SUMS", "`sha256sum -c SHA256SUMS` checks every file")]
    table = "\n".join(f"| `{name}` | {what} |" for name, what in rows)
    return f"""# Langevin Rigid {options.version} for {NAMES[options.platform]}

For programs in C, C++ and C# that simulate leaves, paper, petals and confetti that flutter, glide and tumble: thousands to a million, on the CPU,
with the same bits on every machine. {needs}

| | |
|---|---|
{table}

## First bodies

In this folder:

    {cc}

{run} With CMake:

    cmake -S samples -B build -DCMAKE_PREFIX_PATH={"%CD%" if windows else "$PWD"}
    cmake --build build

In your own `CMakeLists.txt`: `find_package(langevin_rigid {options.version} CONFIG REQUIRED)` and
`target_link_libraries(yours PRIVATE langevin_rigid::langevin_rigid)`. With pkg-config:
`PKG_CONFIG_PATH=lib/pkgconfig pkg-config --cflags --libs langevin_rigid`.

## A body of your own

    bin{chr(92) if windows else "/"}lr_bake{exe} mesh assets/leaf.obj -o leaf.lrb --density 350

It reads OBJ, PLY, STL, glTF, FBX and Collada; `lr_bake --help` lists all options. Pass the file to `lr_asset_load_file`.

## Trouble

- *lr_version differs from the header*: another library is found first. Compare `lr_version()` with `LR_VERSION_*` when you load it.
- *LR_ERROR_ASSET_VERSION*: lr_bake is newer than the library.
{"- *The specified module could not be found*: the DLL is neither beside the program nor in PATH." if windows else "- *cannot open shared object file*: the program was linked without `-rpath`, and the library is in no system folder."}
{"- *LNK1107 or unresolved symbols with MinGW's import library*: give Microsoft's linker `lib/langevin_rigid.lib`." if windows else "- *version GLIBC_... not found*: the system's glibc is older than required above (`ldd --version`)."}
"""


def megabytes(path: Path) -> str:
    return f"{path.stat().st_size / 1e6:.1f} MB"


def note_in_docs(options) -> None:
    text = options.docs.read_text(encoding="utf-8")
    match = re.search(re.escape(BEGIN) + r"\n(.*?)" + re.escape(END), text, re.S)
    if not match:
        sys.exit(f"package_readme.py: {options.docs} has no table between {BEGIN} and {END}")
    rows = {line.split("|")[1].strip(): line for line in match.group(1).splitlines()[2:]}
    library = options.stage / LIBRARY.get(options.platform, "lib/liblangevin_rigid.so")
    baker = options.stage / ("bin/lr_bake.exe" if options.platform.startswith("windows") else "bin/lr_bake")
    rows[options.platform] = (f"| {options.platform} | {options.library_floor or '-'} | {options.baker_floor or '-'} "
                              f"| {megabytes(library)} | {megabytes(baker)} |")
    table = ["| platform | glibc of the library | glibc of lr_bake | library | lr_bake |", "|---|---|---|---|---|",
             *(rows[key] for key in sorted(rows))]
    new = text[:match.start(1)] + "\n".join(table) + "\n" + text[match.end(1):]
    if new != text:
        options.docs.write_text(new, encoding="utf-8")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--platform", required=True, choices=sorted(NAMES))
    parser.add_argument("--version", required=True)
    parser.add_argument("--stage", required=True, type=Path)
    parser.add_argument("--docs", required=True, type=Path)
    parser.add_argument("--library-floor")
    parser.add_argument("--baker-floor")
    options = parser.parse_args()
    (options.stage / "README.md").write_text(read_me(options), encoding="utf-8")
    note_in_docs(options)


if __name__ == "__main__":
    main()
