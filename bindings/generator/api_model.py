#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The public header as data, for generators of bindings: constants, handles, structs with their layout, callbacks, functions, and
what is said of each. Layouts are the compiler's own, by libclang (Debian: python3-clang-14), for any target.

    api_model.py [--target wasm32-unknown-unknown] [--header FILE]     the model as JSON

Types are dictionaries by `kind`:
    scalar    name: void char i8 ... u64 f32 f64
    handle    name: a typedef of a scalar, as lr_batch; of: its scalar
    struct    name
    opaque    name: lr_world, lr_asset, seen through pointers only
    callback  name: a typedef of a pointer to a function
    function  result, parameters: a pointer to a function without a name of its own
    pointer   to, const
    array     of, count
"""
import argparse
import json
import pathlib
import re
import sys

from clang import cindex

import header_comments

HEADER = pathlib.Path(__file__).resolve().parents[2] / "include" / "langevin_rigid.h"
SCALARS = {
    "void": "void", "char": "char", "float": "f32", "double": "f64",
    **{f"{sign}int{bits}_t": f"{sign or 'i'}{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)},
}
STDINT = "".join(f"typedef __{sign}INT{bits}_TYPE__ {sign.lower()}int{bits}_t;\n" for sign in ("", "U") for bits in (8, 16, 32, 64))
COMMENT = re.compile(r"/\*.*?\*/", re.S)
BANNER = re.compile(r"/\* -+ \*/\n/\* (.*?)\s*\*/\n")
DEFINE = re.compile(r"#define (LR_[A-Z0-9_]+)[ \t]+(\(?-?[0-9][0-9a-fx.uf]*\)?)")


class Comments:
    """Which comment belongs to what stands on which lines."""

    def __init__(self, source):
        self.before, self.behind, self.sections = {}, {}, []

        def line_of(at):
            return source.count("\n", 0, at) + 1

        for match in BANNER.finditer(source):
            self.sections.append((line_of(match.start()), match.group(1).strip().rstrip(".")))
        for match in COMMENT.finditer(source):
            first, last = line_of(match.start()), line_of(match.end())
            start = source.rfind("\n", 0, match.start()) + 1
            text = "\n".join(header_comments.text_of(match.group())).strip("\n")
            if source[start:match.start()].strip():
                self.behind[first] = " ".join(text.split())
            elif not re.match(r"-+$", text):
                self.before[last] = text

    def of(self, first, last):
        """Of what goes from one line to another: what is said behind it, else right before it."""
        return self.behind.get(last) or self.before.get(first - 1, "")

    def section(self, line):
        titles = [title for start, title in self.sections if start <= line]
        return titles[-1] if titles else ""


def value_of(text):
    """A constant's value and scalar."""
    text = text.strip("()")
    if text.endswith("f") and not text.startswith("0x"):
        return float(text[:-1]), "f32"
    if text.endswith("u"):
        return int(text[:-1], 0), "u32"
    return int(text, 0), "i32"


def constants(source, comments):
    """All numeric macros. `about`: the text before the run of lines that a macro stands in."""
    found, lines = [], source.split("\n")
    about, expected = "", None
    for number, line in enumerate(lines, 1):
        match = DEFINE.match(line)
        if not match:
            continue
        if number != expected:
            about = comments.before.get(number - 1, "")
        end = number  # a comment behind it may go on over lines
        if "/*" in line:
            while "*/" not in lines[end - 1]:
                end += 1
        expected = end + 1
        value, scalar = value_of(match.group(2))
        found.append({"name": match.group(1), "value": value, "scalar": scalar, "doc": comments.behind.get(number, ""),
                      "about": about, "section": comments.section(number)})
    return found


class Reader:
    def __init__(self, unit, header, source):
        self.unit, self.header, self.source, self.comments = unit, header, source, Comments(source)
        own = [cursor for cursor in unit.cursor.get_children()
               if cursor.location.file and cursor.location.file.name == str(header)]
        self.own = own
        kind = cindex.CursorKind
        self.records = {cursor.spelling: cursor for cursor in own if cursor.kind == kind.STRUCT_DECL}
        self.typedefs = {cursor.spelling: cursor for cursor in own if cursor.kind == kind.TYPEDEF_DECL}

    def is_callback(self, name):
        underlying = self.typedefs[name].underlying_typedef_type
        return underlying.kind == cindex.TypeKind.POINTER and \
            underlying.get_pointee().get_canonical().kind == cindex.TypeKind.FUNCTIONPROTO

    def type(self, type_, names=()):
        """names: of the parameters, where it is a pointer to a function."""
        kind = cindex.TypeKind
        name = type_.spelling.removeprefix("const ").strip()
        if name in SCALARS:
            return {"kind": "scalar", "name": SCALARS[name]}
        if type_.kind in (kind.ELABORATED, kind.RECORD, kind.TYPEDEF):
            name = name.removeprefix("struct ")
            if name in self.typedefs and self.is_callback(name):
                return {"kind": "callback", "name": name}
            if name in self.records:
                record = self.records[name]
                whole = record.get_definition() is not None
                return {"kind": "struct" if whole else "opaque", "name": name}
            if name in self.typedefs:
                return {"kind": "handle", "name": name,
                        "of": self.type(self.typedefs[name].underlying_typedef_type)["name"]}
        if type_.kind == kind.CONSTANTARRAY:
            return {"kind": "array", "of": self.type(type_.element_type), "count": type_.element_count}
        if type_.kind == kind.POINTER:
            pointee = type_.get_pointee()
            if pointee.get_canonical().kind == kind.FUNCTIONPROTO:
                prototype = pointee.get_canonical() if pointee.kind == kind.TYPEDEF else pointee
                arguments = [self.type(argument) for argument in prototype.argument_types()]
                return {"kind": "function", "result": self.type(prototype.get_result()),
                        "parameters": [{"name": n, "type": t} for n, t in zip(names, arguments, strict=True)]}
            return {"kind": "pointer", "to": self.type(pointee), "const": pointee.is_const_qualified()}
        raise ValueError(f"{self.header}: a type that no rule is for: {type_.spelling} ({type_.kind})")

    def parameters(self, cursor):
        return [child.spelling for child in cursor.get_children() if child.kind == cindex.CursorKind.PARM_DECL]

    def doc(self, cursor):
        return self.comments.of(cursor.extent.start.line, cursor.extent.end.line)

    def place(self, cursor):
        return {"section": self.comments.section(cursor.extent.start.line), "line": cursor.extent.start.line}

    def structs(self):
        functions = {cursor.spelling for cursor in self.own if cursor.kind == cindex.CursorKind.FUNCTION_DECL}
        for name, cursor in self.records.items():
            cursor = cursor.get_definition()
            if cursor is None:
                continue
            type_, fields, about = cursor.type, [], ""
            for field in cursor.get_children():
                if field.kind != cindex.CursorKind.FIELD_DECL:
                    continue
                fields.append({"name": field.spelling, "type": self.type(field.type, self.parameters(field)),
                               "offset": type_.get_offset(field.spelling) // 8, "size": field.type.get_size(),
                               "doc": self.comments.behind.get(field.extent.end.line, ""),
                               "about": self.comments.before.get(field.extent.start.line - 1, "")})
            yield {"name": name, "size": type_.get_size(), "alignment": type_.get_align(), "fields": fields,
                   "doc": self.comments.before.get(cursor.extent.start.line - 1, ""),
                   "init": f"{name}_init" if f"{name}_init" in functions else None, **self.place(cursor)}

    def handles(self):
        for name, cursor in self.typedefs.items():
            underlying = cursor.underlying_typedef_type
            if underlying.spelling in SCALARS:
                yield {"name": name, "of": SCALARS[underlying.spelling], "doc": self.doc(cursor), **self.place(cursor)}

    def callbacks(self):
        for name, cursor in self.typedefs.items():
            if self.is_callback(name):
                signature = self.type(cursor.underlying_typedef_type, self.parameters(cursor))
                yield {"name": name, "result": signature["result"], "parameters": signature["parameters"],
                       "doc": self.doc(cursor), **self.place(cursor)}

    def functions(self):
        for cursor in self.own:
            if cursor.kind != cindex.CursorKind.FUNCTION_DECL:
                continue
            names = [argument.spelling for argument in cursor.get_arguments()]
            text = self.comments.before.get(cursor.extent.start.line - 1, "")
            summary, said, returns, threads = header_comments.split(text, names)
            yield {"name": cursor.spelling, "result": self.type(cursor.result_type),
                   "parameters": [{"name": argument.spelling, "type": self.type(argument.type),
                                   "doc": said.get(argument.spelling, "")} for argument in cursor.get_arguments()],
                   "doc": summary, "returns": returns, "threads": threads,
                   "statuses": sorted(set(re.findall(r"LR_OK|LR_ERROR_[A-Z_]+[A-Z]", returns))), **self.place(cursor)}


def read(header=HEADER, target="x86_64-unknown-linux-gnu"):
    """The model of a header, with the sizes and offsets that it has on a target."""
    header = pathlib.Path(header)
    source = header.read_text(encoding="utf-8")
    # No target needs a C library, nor the compiler's own headers, for the few types that the header takes from one.
    unit = cindex.Index.create().parse(
        str(header), args=["-x", "c", "-std=c99", "-nostdinc", "-I/provided", f"--target={target}"],
        unsaved_files=[("/provided/stdint.h", STDINT)])
    errors = [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        raise ValueError("\n".join(errors))
    reader = Reader(unit, header, source)
    all_constants = constants(source, reader.comments)
    version = {c["name"][11:].lower(): c["value"] for c in all_constants if c["name"].startswith("LR_VERSION_")}
    return {
        "version": version,
        "constants": [c for c in all_constants if not c["name"].startswith("LR_VERSION_")],
        "opaque": [name for name, cursor in reader.records.items() if cursor.get_definition() is None],
        "handles": list(reader.handles()),
        "structs": list(reader.structs()),
        "callbacks": list(reader.callbacks()),
        "functions": list(reader.functions()),
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--header", default=HEADER)
    parser.add_argument("--target", default="x86_64-unknown-linux-gnu")
    options = parser.parse_args()
    json.dump(read(options.header, options.target), sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
