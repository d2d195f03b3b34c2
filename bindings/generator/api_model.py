#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Reads the public header as data for the generators: constants, handles, structs with their layout, callbacks, functions, and their
comments. libclang (Debian: python3-clang-14) gives the compiler's own layouts, for any target.

    api_model.py [--target wasm32-unknown-unknown] [--header FILE]     the model as JSON

Types are dictionaries by `kind`:
    scalar    name: void char i8 ... u64 f32 f64; enum: if its values have names, as lr_load_model
    handle    name: lr_status, or the handle's type, as lr_batch; of: its scalar
    struct    name
    opaque    name: lr_world, lr_asset, used only through pointers
    callback  name: a typedef of a pointer to a function
    function  result, parameters: an unnamed pointer to a function
    pointer   to, const
    array     of, count

Named values are macros, or a typedef with an enum right after it, which `enums` lists:
    typedef int32_t lr_load_model;
    enum { LR_LOADS_DEFAULT = 0, LR_LOADS_NONE = 1 };
A handle is a typedef of a number, or a struct of one number: typedef struct lr_body { uint64_t id; } lr_body;

Pointer parameters say whether they can be null (`nullable`), by their text or by a note behind LR_ERROR_NULL_ARGUMENT that names
the pointers that cannot. `null` of a function: whether null in place of its struct clears what was set, or resets it.
"""
import argparse
import json
import os
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
    """Finds the comment of a declaration by its lines."""

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
        """The comment of a declaration on these lines: behind it, or else right before it."""
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
    """All numeric macros. `about`: the text before the run of lines with the macro."""
    found, lines = [], source.split("\n")
    about, expected = "", None
    for number, line in enumerate(lines, 1):
        match = DEFINE.match(line)
        if not match:
            continue
        if number != expected:
            about = comments.before.get(number - 1, "")
        end = number  # a comment behind it can continue on more lines
        if "/*" in line:
            while "*/" not in lines[end - 1]:
                end += 1
        expected = end + 1
        value, scalar = value_of(match.group(2))
        found.append({"name": match.group(1), "value": value, "scalar": scalar, "doc": comments.behind.get(number, ""),
                      "about": about, "section": comments.section(number), "line": number})
    return found


def prefix_of(names, enum):
    """The common prefix of an enum's members, up to an underscore; of a single member, the words of the enum's name."""
    shared = os.path.commonprefix(names) if len(names) > 1 else "LR_"
    words = enum.upper().split("_")
    while len(names) == 1 and words and not names[0].startswith("_".join(words) + "_"):
        words.pop()
    return shared[:shared.rindex("_") + 1] if len(names) > 1 else "_".join(words) + "_"


class Reader:
    def __init__(self, unit, files):
        self.comments = {str(file): Comments(source) for file, source in files.items()}
        own = [cursor for cursor in unit.cursor.get_children()
               if cursor.location.file and cursor.location.file.name in self.comments]
        self.own = own
        kind = cindex.CursorKind
        self.records = {cursor.spelling: cursor for cursor in own if cursor.kind == kind.STRUCT_DECL}
        self.typedefs = {cursor.spelling: cursor for cursor in own if cursor.kind == kind.TYPEDEF_DECL}
        self.enum_of = {before.spelling: cursor for before, cursor in zip(own, own[1:])
                        if before.kind == kind.TYPEDEF_DECL and cursor.kind == kind.ENUM_DECL}

    def is_callback(self, name):
        underlying = self.typedefs[name].underlying_typedef_type
        return underlying.kind == cindex.TypeKind.POINTER and \
            underlying.get_pointee().get_canonical().kind == cindex.TypeKind.FUNCTIONPROTO

    def handle_of(self, name):
        """The scalar of a handle; None for other names."""
        if name in self.records:
            fields = list(self.records[name].type.get_fields())
            return SCALARS.get(fields[0].type.spelling) if [f.spelling for f in fields] == ["id"] else None
        if name in self.typedefs and (name not in self.enum_of or name == "lr_status"):
            return SCALARS.get(self.typedefs[name].underlying_typedef_type.spelling)
        return None

    def type(self, type_, names=()):
        """names: parameter names of a pointer to a function."""
        kind = cindex.TypeKind
        name = type_.spelling.removeprefix("const ").strip()
        if name in SCALARS:
            return {"kind": "scalar", "name": SCALARS[name]}
        if type_.kind in (kind.ELABORATED, kind.RECORD, kind.TYPEDEF):
            name = name.removeprefix("struct ")
            if name in self.typedefs and self.is_callback(name):
                return {"kind": "callback", "name": name}
            if of := self.handle_of(name):
                return {"kind": "handle", "name": name, "of": of}
            if name in self.records:
                record = self.records[name]
                whole = record.get_definition() is not None
                return {"kind": "struct" if whole else "opaque", "name": name}
            if name in self.enum_of:
                return {**self.type(self.typedefs[name].underlying_typedef_type), "enum": name}
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
        raise ValueError(f"no rule for the type {type_.spelling} ({type_.kind})")

    def parameters(self, cursor):
        return [child.spelling for child in cursor.get_children() if child.kind == cindex.CursorKind.PARM_DECL]

    def said(self, cursor):
        return self.comments[cursor.location.file.name]

    def doc(self, cursor):
        return self.said(cursor).of(cursor.extent.start.line, cursor.extent.end.line)

    def place(self, cursor):
        return {"section": self.said(cursor).section(cursor.extent.start.line), "line": cursor.extent.start.line}

    def structs(self):
        functions = {cursor.spelling for cursor in self.own if cursor.kind == cindex.CursorKind.FUNCTION_DECL}
        for name, cursor in self.records.items():
            cursor = cursor.get_definition()
            if cursor is None or self.handle_of(name):
                continue
            type_, fields, about = cursor.type, [], ""
            for field in cursor.get_children():
                if field.kind != cindex.CursorKind.FIELD_DECL:
                    continue
                fields.append({"name": field.spelling, "type": self.type(field.type, self.parameters(field)),
                               "offset": type_.get_offset(field.spelling) // 8, "size": field.type.get_size(),
                               "doc": self.said(field).behind.get(field.extent.end.line, ""),
                               "about": self.said(field).before.get(field.extent.start.line - 1, "")})
            yield {"name": name, "size": type_.get_size(), "alignment": type_.get_align(), "fields": fields,
                   "doc": self.said(cursor).before.get(cursor.extent.start.line - 1, ""),
                   "init": f"{name}_init" if f"{name}_init" in functions else None, **self.place(cursor)}

    def handles(self):
        for cursor in self.own:
            name, kind = cursor.spelling, cursor.kind
            if kind in (cindex.CursorKind.TYPEDEF_DECL, cindex.CursorKind.STRUCT_DECL) and self.handle_of(name) and \
                    not (kind == cindex.CursorKind.TYPEDEF_DECL and name in self.records):
                yield {"name": name, "of": self.handle_of(name), "doc": self.doc(cursor), **self.place(cursor)}

    def enums(self):
        """Enums; members have the form of constants."""
        for name, cursor in self.enum_of.items():
            typedef = self.typedefs[name]
            scalar, about, members = SCALARS[typedef.underlying_typedef_type.spelling], self.doc(typedef), []
            for member in cursor.get_children():
                line = member.extent.end.line
                members.append({"name": member.spelling, "value": member.enum_value, "scalar": scalar, "enum": name,
                                "doc": self.said(member).behind.get(line, ""), "about": about, **self.place(member)})
            yield {"name": name, "of": scalar, "doc": about, "file": typedef.location.file.name, "members": members, "prefix": prefix_of([m["name"] for m in members], name),
                   **self.place(typedef)}

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
            text = self.said(cursor).before.get(cursor.extent.start.line - 1, "")
            summary, said, returns, threads = header_comments.split(text, names)
            note = re.search(r"LR_ERROR_NULL_ARGUMENT\s+\(([a-z_,\s]+)\)", returns)
            asked = re.split(r",\s+", note.group(1)) if note and note.group(1).startswith("world") else None
            null = re.search(r"\bnull\s+(removes|clears|means|restores|sets)\b", summary)
            parameters = []
            for argument in cursor.get_arguments():
                name, type_ = argument.spelling, self.type(argument.type)
                doc = said.get(name, "")
                nullable = type_["kind"] == "callback" or name == "user" or type_["kind"] == "pointer" and bool(
                    asked and name not in asked or null and type_["const"] and type_["to"]["kind"] == "struct" or re.search(r"\bmay\s+be\s+null(?!\s+(?:when|only))", doc))
                parameters.append({"name": name, "type": type_, "doc": doc, "nullable": nullable})
            yield {"name": cursor.spelling, "result": self.type(cursor.result_type), "parameters": parameters,
                   "null": null and ("clear" if null.group(1) in ("removes", "clears", "means") else "reset"),
                   "doc": summary, "returns": returns, "threads": threads,
                   "statuses": sorted(set(re.findall(r"LR_OK|LR_ERROR_[A-Z_]+[A-Z]", returns))), **self.place(cursor)}


def files_of(header):
    """A header, and NAME_research.h beside it, which includes it."""
    header = pathlib.Path(header)
    more = header.with_name(header.stem + "_research.h")
    return [header, more] if more.exists() else [header]


def read(header=HEADER, target="x86_64-unknown-linux-gnu"):
    """The model of a header, and of NAME_research.h beside it, with the sizes and offsets that they have on a target."""
    files = {file: file.read_text(encoding="utf-8") for file in files_of(header)}
    # No target needs a C library, nor the compiler's own headers, for the few types that the header takes from one.
    unit = cindex.Index.create().parse(
        str(list(files)[-1]), args=["-x", "c", "-std=c99", "-nostdinc", "-I/provided", f"--target={target}"],
        unsaved_files=[("/provided/stdint.h", STDINT)])
    errors = [str(d) for d in unit.diagnostics if d.severity >= cindex.Diagnostic.Error]
    if errors:
        raise ValueError("\n".join(errors))
    reader = Reader(unit, files)
    enums = list(reader.enums())
    all_constants = []
    for file, source in files.items():
        found = constants(source, reader.comments[str(file)])
        found += [member for enum in enums if enum["file"] == str(file) for member in enum["members"]]
        all_constants += sorted(found, key=lambda constant: constant.pop("line"))
    version = {c["name"][11:].lower(): c["value"] for c in all_constants if c["name"].startswith("LR_VERSION_")}
    return {
        "version": version,
        "constants": [c for c in all_constants if not c["name"].startswith("LR_VERSION_")],
        "opaque": [name for name, cursor in reader.records.items() if cursor.get_definition() is None],
        "enums": enums,
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
