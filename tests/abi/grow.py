#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Has every struct that callers size grow at its end, in a copy of the tree: the header, and the sizes before it in
src/api/arguments.h, as whoever adds a field would. Used by grown_library.sh.
    grow.py TREE"""
import pathlib
import re
import sys

import surface

tree = pathlib.Path(sys.argv[1])
header, arguments = tree / "include" / "langevin_rigid.h", tree / "src" / "api" / "arguments.h"
names = [name for name, struct in surface.Surface(header).structs.items() if struct["grows"]]
text = header.read_text()
for name in names:
    text, count = re.subn(rf"^\}} {name};$", f"    float grown[2];\n}} {name};", text, flags=re.M)
    assert count == 1, name
header.write_text(text)

text = arguments.read_text()
sizes = dict(re.findall(r"earlier_sizes<(lr_\w+)>\{(.*)\};\n", text))
text = re.sub(r"template <> inline constexpr std::array earlier_sizes<.*\n", "", text)
lines = [f"template <> inline constexpr std::array earlier_sizes<{name}>{{{sizes.get(name, '')}{', ' if name in sizes else ''}"
         f"offsetof({name}, grown)}};\n" for name in names]
primary = re.search(r"template <class T> inline constexpr std::array<size_t, 0> earlier_sizes\{\};\n", text)
arguments.write_text(text[:primary.end()] + "".join(lines) + text[primary.end():])
print(f"{len(names)} structs have grown")
