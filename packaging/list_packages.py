#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes SHA256SUMS and index.html of a folder of packages: what each is for, and its size.

    list_packages.py FOLDER
"""
import hashlib
import html
import sys
from pathlib import Path

# The end of a file's name, for whom it is, what it has. Files of no row are an error: a page that lists all must say what each is for.
PURPOSES = [
    ("linux-x64.tar.xz", "Linux on x86-64", "Library, static library, headers, lr_bake and other tools, bindings for C# and Python, "
     "baked leaves. glibc 2.17, the tools 2.30."),
    ("linux-arm64.tar.xz", "Linux on 64-bit ARM", "The same, without the wheel."),
    ("windows-x64.zip", "Windows 10 and later on x86-64", "The same with a DLL, and import libraries for Microsoft's and MinGW's linkers."),
    ("macos.tar.xz", "macOS 11 and later, Apple silicon and Intel", "Library and static library for both processors. Cross-compiled; <b>not yet run</b>."),
    ("godot.zip", "Godot 4.4 and later", "The addon, with a scene to try, for Linux, Windows and macOS."),
    ("unity.tgz", "Unity 2022.3 and later", "The package, with a sample and a bake window. Compiled against a stand-in for the engine, <b>not yet run in it</b>."),
    ("unreal.zip", "Unreal Engine 5.4 and later", "The plugin, for Windows and Linux. Compiled against a stand-in for the engine, <b>not yet run in it</b>."),
    ("wasm.tar.xz", "The web", "WebAssembly with JavaScript and types, and a page to try."),
    ("source.tar.xz", "Consoles, phones, Microsoft's compiler, vcpkg, Conan",
     "The runtime's sources with all that it contains, one CMake file; threads through a job system where there is no system."),
]


def main() -> None:
    folder = Path(sys.argv[1])
    for file in folder.glob("*.sha256"):
        file.unlink()
    files = sorted(p for p in folder.iterdir() if p.is_file() and p.name not in ("SHA256SUMS", "index.html"))
    sums, rows, version = [], [], ""
    for end, platform, what in PURPOSES:
        for file in (p for p in files if p.name.endswith("-" + end)):
            version = file.name.removeprefix("langevin_rigid-").removesuffix("-" + end)
            rows.append(f'<tr><td><a href="{html.escape(file.name)}">{html.escape(file.name)}</a><td>{platform}<td>{what}'
                        f"<td>{file.stat().st_size / 1e6:.1f} MB")
    for file in files:
        if not any(file.name.endswith("-" + end) for end, _, _ in PURPOSES):
            sys.exit(f"list_packages.py: {file.name} has no row in PURPOSES")
        sums.append(f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n")
    (folder / "SHA256SUMS").write_text("".join(sums), encoding="utf-8")
    (folder / "index.html").write_text(
        '<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>Langevin Rigid {version}</title>\n"
        "<style>body{font:16px/1.5 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}td,th{text-align:left;vertical-align:top;"
        "padding:.4em .8em .4em 0;border-top:1px solid #ccc}</style>\n"
        f"<h1>Langevin Rigid {version}</h1>\n<p>Leaves, paper and sinking things that flutter and tumble. Unpack the file of your platform: its README.md has the "
        'first steps. Check a download: <code>sha256sum --ignore-missing -c <a href="SHA256SUMS">SHA256SUMS</a></code>.</p>\n'
        "<table><tr><th>file<th>for<th>what is in it<th>size\n" + "\n".join(rows) + "\n</table>\n"
        + ('<p><a href="docs/index.html">Documentation</a>, with tutorial, recipes and API reference</p>\n' if (folder / "docs").is_dir() else ""), encoding="utf-8")
    print(f"{folder}: {len(files)} packages, {sum(p.stat().st_size for p in files) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
