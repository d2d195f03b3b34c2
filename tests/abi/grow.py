#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Has every struct that callers size grow at its end, in a copy of the tree: the header, and the sizes before it in
src/api/arguments.h, as whoever adds a field would. Used by grown_library.sh.
    grow.py TREE"""
import pathlib
import re
import sys

import surface


def grown_header(header):
    """The text of a header in which every struct that may grow has, and the names of those."""
    structs = {name: struct for name, struct in surface.Surface(header).structs.items() if struct["grows"]}
    text = pathlib.Path(header).read_text()
    for name, struct in structs.items():
        # Of the struct's own alignment: a smaller field behind a pointer would lie in what is padding on 32 bits.
        field = "uint64_t grown" if min(struct["alignments"]) == 8 else "float grown[2]"
        text, count = re.subn(rf"^\}} {name};$", f"    {field};\n}} {name};", text, flags=re.M)
        assert count == 1, name
    return text, list(structs)


def grown_arguments(text, names):
    """src/api/arguments.h with the sizes before that."""
    held = r"template <>\s+inline constexpr std::array earlier_sizes<(lr_\w+)>\{([^}]*)\};\n"
    sizes = dict(re.findall(held, text))
    text = re.sub(held, "", text)
    lines = [f"template <> inline constexpr std::array earlier_sizes<{name}>{{{sizes.get(name, '')}{', ' if name in sizes else ''}"
             f"offsetof({name}, grown)}};\n" for name in names]
    primary = re.search(r"template <class T> inline constexpr std::array<size_t, 0> earlier_sizes\{\};\n", text)
    return text[:primary.end()] + "".join(lines) + text[primary.end():]


def main(tree):
    header, arguments = tree / "include" / "langevin_rigid.h", tree / "src" / "api" / "arguments.h"
    text, names = grown_header(header)
    header.write_text(text)
    arguments.write_text(grown_arguments(arguments.read_text(), names))
    print(f"{len(names)} structs have grown")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
