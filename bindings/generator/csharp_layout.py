#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes two programs that print the layout of every struct and handle and the value of every constant: layout.c for the C compiler,
Layout.cs for C#. Their output must be the same.

    csharp_layout.py DIR
"""
import pathlib
import sys

import api_model
import csharp
from csharp_names import pascal, suffixes, type_name


def c_fields(generator, struct):
    """The name in C#, and the C expression."""
    for field in struct["fields"]:
        name, type_ = pascal(field["name"]), field["type"]
        if type_["kind"] == "array" and type_["of"]["kind"] in ("pointer", "struct"):
            ends = suffixes(type_["count"]) if type_["of"]["kind"] == "pointer" else map(str, range(type_["count"]))
            for i, suffix in enumerate(ends):
                yield name + suffix, f"{field['name']}[{i}]"
        else:
            yield name, field["name"]


def c_program(generator):
    lines = ["#include <langevin_rigid_research.h>", "#include <stddef.h>", "#include <stdio.h>", "", "int main(void) {"]
    for struct in generator.model["structs"]:
        name, cs = struct["name"], type_name(struct["name"])
        lines.append(f'    printf("{cs} %u\\n", (unsigned)sizeof({name}));')
        for cs_field, field in c_fields(generator, struct):
            lines.append(f'    printf("{cs}.{cs_field} %u %u\\n", (unsigned)offsetof({name}, {field}), (unsigned)sizeof((({name}*)0)->{field}));')
    for handle in generator.model["handles"]:
        lines.append(f'    printf("{type_name(handle["name"])} %u\\n", (unsigned)sizeof({handle["name"]}));')
    for constant, (enum, member) in generator.names.enum_of.items():
        lines.append(f'    printf("{enum}.{member} %.17g\\n", (double){constant});')
    for part in generator.model["version"]:
        lines.append(f'    printf("Limits.Version{part.capitalize()} %.17g\\n", (double)LR_VERSION_{part.upper()});')
    return "\n".join([*lines, "    return 0;", "}", ""])


def cs_program(generator):
    lines = ["using System;", "using System.Globalization;", "using LangevinRigid;", "", "unsafe static class Layout", "{",
             "    static void Say(string name, double value) { Console.WriteLine(name + \" \" + value.ToString(\"R\", CultureInfo.InvariantCulture)); }",
             "    static void Say(string name, void* start, void* field, int size)", "    {",
             "        Console.WriteLine(name + \" \" + ((byte*)field - (byte*)start) + \" \" + size);", "    }", ""]
    body = []
    for i, struct in enumerate(generator.model["structs"]):
        name = type_name(struct["name"])
        body.append(f"        S{i}();")
        lines += [f"    static void S{i}()", "    {", f"        var v = default({name});", f'        Say("{name}", sizeof({name}));']
        for declaration, field, *_ in generator.fields(struct):
            type_ = declaration.rsplit(" ", 1)[0]
            if type_.startswith("fixed "):
                count = declaration[declaration.index("[") + 1:-1]
                lines.append(f'        Say("{name}.{field}", &v, v.{field}, sizeof({type_[6:]}) * {count});')
            else:
                lines.append(f'        Say("{name}.{field}", &v, &v.{field}, sizeof({type_}));')
        lines += ["    }", ""]
    for handle in generator.model["handles"]:
        body.append(f'        Say("{type_name(handle["name"])}", sizeof({type_name(handle["name"])}));')
    for enum, member in generator.names.enum_of.values():
        body.append(f'        Say("{enum}.{member}", (double){enum}.{member});')
    for part in generator.model["version"]:
        body.append(f'        Say("Limits.Version{part.capitalize()}", Limits.Version{part.capitalize()});')
    return "\n".join([*lines, "    static void Main()", "    {", *body, "    }", "}", ""])


def main():
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    generator = csharp.Generator(api_model.read())
    (out / "layout.c").write_text(c_program(generator), encoding="utf-8")
    (out / "Layout.cs").write_text(cs_program(generator), encoding="utf-8")


if __name__ == "__main__":
    main()
