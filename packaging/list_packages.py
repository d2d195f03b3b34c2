#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes SHA256SUMS and index.html of a folder of packages: what each is for, its first step, and its size.

    list_packages.py FOLDER
"""
import hashlib
import html
import re
import sys
from pathlib import Path

VERSION = re.search(r"project\(langevin_rigid VERSION ([0-9.]+)", (Path(__file__).parents[1] / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
NATIVE = f"langevin_rigid-{VERSION}-"
UNPACK = "Unpack it; README.md has the first program"
LANGUAGES, ENGINES = "docs/docs/guide/languages.html#", "docs/docs/guide/engines.html#"
# Heading, then: name of the file, what it is for, what is in it, first step and the page that has it. A file without a row is an error.
ROWS = [
    ("C, C++, C#",),
    (NATIVE + r"linux-x64\.tar\.xz", "Linux on x86-64", "library, static library, headers, lr_bake, lr_drop, baked leaves, C# sources; glibc 2.17, tools 2.30", UNPACK, LANGUAGES + "c-and-c"),
    (NATIVE + r"linux-arm64\.tar\.xz", "Linux on 64-bit ARM", "the same", UNPACK, LANGUAGES + "c-and-c"),
    (NATIVE + r"windows-x64\.zip", "Windows 10 and later", "the same with a DLL, and import libraries for Microsoft's and MinGW's linkers", UNPACK, LANGUAGES + "c-and-c"),
    (NATIVE + r"macos\.tar\.xz", "macOS 11 and later, Apple silicon and Intel", "library and static library. Cross-compiled; <b>not yet run</b>", UNPACK, LANGUAGES + "c-and-c"),
    (NATIVE + r"source\.tar\.xz", "consoles, phones, Microsoft's compiler, vcpkg, Conan", "sources of the library and of all it contains, one CMake file",
     UNPACK, LANGUAGES + "c-and-c"),
    ("Engines",),
    (NATIVE + r"unity\.tgz", "Unity 2022.3 and later", "package with libraries, bake window and a sample. Compiled against a stand-in; <b>not yet run in Unity</b>",
     "Package Manager, +, <i>Install package from tarball</i>", ENGINES + "unity-ten-minutes"),
    (NATIVE + r"unreal\.zip", "Unreal 5.4 and later", "plugin with libraries for Windows and Linux. Compiled against a stand-in; <b>not yet run in Unreal</b>",
     "Unpack into the project's <i>Plugins</i>", ENGINES + "unreal-ten-minutes"),
    (NATIVE + r"godot\.zip", "Godot 4.4 and later", "the addon for Linux, Windows and macOS, with a scene to try", "Unpack into the project; play addons/langevin_rigid/demo/storm.tscn", ENGINES + "godot-ten-minutes"),
    ("Python and Blender",),
    (rf"leaf_storm-{VERSION}-linux-x64\.zip", "Blender 3.4 and later on Linux", "add-on with all it needs", "Preferences, <i>Install from Disk</i>", LANGUAGES + "blender"),
    (rf"leaf_storm-{VERSION}-windows-x64\.zip", "Blender on Windows", "the same", "Preferences, <i>Install from Disk</i>", LANGUAGES + "blender"),
    (NATIVE + r"py3-none-manylinux_\d+_\d+_x86_64\.whl", "Python 3.9 and later, Linux on x86-64", "module with library and lr_bake", "pip install FILE", LANGUAGES + "python-from-zero-to-falling-leaves"),
    (NATIVE + r"py3-none-manylinux_\d+_\d+_aarch64\.whl", "Python, Linux on 64-bit ARM", "the same", "pip install FILE", LANGUAGES + "python-from-zero-to-falling-leaves"),
    (NATIVE + r"py3-none-win_amd64\.whl", "Python, Windows", "the same", "pip install FILE", LANGUAGES + "python-from-zero-to-falling-leaves"),
    ("The web",),
    (rf"langevin-rigid-{VERSION}\.tgz", "browsers and node, three.js", "WebAssembly with a JavaScript module and types", "npm install ./FILE", LANGUAGES + "web-from-zero-to-falling-leaves"),
]
STYLE = """body{font:16px/1.5 sans-serif;max-width:66em;margin:2em auto;padding:0 1em;color:#222}a{color:#b33c00}h2{font-size:1.1em;margin:1.6em 0 .2em}
table{border-collapse:collapse;width:100%;table-layout:fixed}td{text-align:left;vertical-align:top;padding:.4em .8em .4em 0;border-top:1px solid #ccc}
td:nth-child(1){width:17em;overflow-wrap:anywhere}td:nth-child(3){width:19em;overflow-wrap:anywhere}td:nth-child(4){width:4.5em;white-space:nowrap;text-align:right;padding-right:0}
@media(max-width:50em){td{display:block;border:0;padding:0;width:auto!important}td:nth-child(4){text-align:left}tr{display:block;border-top:1px solid #ccc;padding:.5em 0}}"""


def main() -> None:
    folder = Path(sys.argv[1])
    files = sorted(p for p in folder.iterdir() if p.is_file() and p.name not in ("SHA256SUMS", "index.html"))
    known = [row for row in ROWS if len(row) > 1]
    for file in files:
        if not any(re.fullmatch(row[0], file.name) for row in known):
            sys.exit(f"list_packages.py: {file} is in no row of ROWS: is it of another version?")
    body, docs = [], (folder / "docs").is_dir()
    for row in ROWS:
        if len(row) == 1:
            body.append(f"</table>\n<h2>{row[0]}</h2>\n<table>")
            continue
        pattern, purpose, contents, step, page = row
        for file in (p for p in files if re.fullmatch(pattern, p.name)):
            name = html.escape(file.name)
            more = f' (<a href="{page}">first steps</a>)' if docs else ""
            body.append(f'<tr><td><b>{purpose}</b><br><a href="{name}">{name}</a><td>{contents}<td>{step.replace("FILE", name)}{more}'
                        f"<td>{file.stat().st_size / 1e6:.1f} MB")
    links = [f'<a href="{page}">{text}</a>' for page, text in (("docs/index.html", "Documentation"), ("docs/docs/guide/tutorial.html", "Tutorial"),
             ("web/index.html", "Try it in the browser")) if (folder / page).is_file()]
    (folder / "SHA256SUMS").write_text("".join(f"{hashlib.sha256(p.read_bytes()).hexdigest()}  {p.name}\n" for p in files), encoding="utf-8")
    text = (f'<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">\n<title>Langevin Rigid {VERSION}</title>\n'
            f"<style>{STYLE}</style>\n<h1>Langevin Rigid {VERSION}</h1>\n<p>Leaves, paper, petals and confetti that flutter and tumble, for games and films. "
            f'{" · ".join(links)}\n<table>' + "\n".join(body) + '\n</table>\n<p>Check downloads by <code>sha256sum --ignore-missing -c '
            '<a href="SHA256SUMS">SHA256SUMS</a></code>. MIT licence; every package holds the licences of the software inside.\n')
    (folder / "index.html").write_text(re.sub(r"<h2>[^<]*</h2>\n<table>\s*</table>\n", "", text.replace("<table></table>\n", "")), encoding="utf-8")
    print(f"{folder}: {len(files)} packages, {sum(p.stat().st_size for p in files) / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
