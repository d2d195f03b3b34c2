#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes what the WebAssembly package knows of the C API, from the public header as wasm32 sees it: constants, layouts of structs, and
types for TypeScript.

    javascript.py            writes bindings/web/src/generated/
    javascript.py --check    writes nothing, and fails where that would change a file
"""
import argparse
import pathlib
import re
import sys

import api_model

OUT = pathlib.Path(__file__).resolve().parents[1] / "web" / "src" / "generated"
NOTICE = "// Made by bindings/generator/javascript.py from include/langevin_rigid.h: changes here are lost.\n" \
         "// SPDX-License-Identifier: MIT\n"
# Of 64 bits: what is compared or handed on, and never counted with, is a bigint; other numbers stay below 2^53.
WHOLE_WORDS = {"seed", "content_hash"}


def camel(name):
    head, *rest = name.split("_")
    return head + "".join(word.capitalize() for word in rest)


def class_name(struct):
    return camel("x_" + struct.removeprefix("lr_"))[1:]


def is_kept(field):
    """Fields that say something to those who use them."""
    return field["name"] != "struct_size" and not re.match(r"reserved(_\d+)?$", field["name"])


def layout_type(field, type_):
    """How a field is read and written: a scalar's name, a struct's, `char`, or `pointer`."""
    kind = type_["kind"]
    if kind == "scalar":
        return "big" if type_["name"] == "u64" and field["name"] in WHOLE_WORDS else type_["name"]
    if kind == "handle":
        return "big" if type_["of"] == "u64" else type_["of"]
    if kind == "struct":
        return type_["name"]
    return "pointer"


def layout(struct):
    rows = []
    for field in struct["fields"]:
        if not is_kept(field):
            continue
        type_ = field["type"]
        count = type_["count"] if type_["kind"] == "array" else 0
        of = type_["of"] if type_["kind"] == "array" else type_
        rows.append(f"      ['{camel(field['name'])}', {field['offset']}, '{layout_type(field, of)}', {count}],")
    sized = struct["fields"][0]["name"] == "struct_size"
    init = f"'{struct['init']}'" if struct["init"] else "null"
    return "\n".join([f"  {struct['name']}: {{", f"    size: {struct['size']}, init: {init}, sized: {str(sized).lower()},",
                      "    fields: [", *rows, "    ],", "  },"])


def number(constant):
    return repr(constant["value"]) if constant["scalar"] != "f32" else f"{constant['value']:g}"


def javascript(model):
    version = model["version"]
    packed = version["major"] << 22 | version["minor"] << 12 | version["patch"]
    lines = [NOTICE, f"export const headerVersion = {packed};", "", "export const LR = Object.freeze({"]
    lines += [f"  {c['name'].removeprefix('LR_')}: {number(c)}," for c in model["constants"]]
    lines += ["});", "", "// Fields: name, offset, type, elements (0: no array).", "export const structs = {"]
    lines += [layout(struct) for struct in model["structs"]]
    lines += ["};", "", "export const functions = ["]
    lines += [f"  '{f['name']}'," for f in model["functions"]]
    return "\n".join(lines + ["];", ""])


def comment(text, indent=""):
    text = text.strip().replace("*/", "* /")
    if not text:
        return []
    lines = text.split("\n")
    if len(lines) == 1:
        return [f"{indent}/** {lines[0]} */"]
    return [f"{indent}/**", *[f"{indent} * {line}".rstrip() for line in lines], f"{indent} */"]


POINTED = {"f32": "Float32Array", "f64": "Float64Array", "u32": "Uint32Array", "i32": "Int32Array", "lr_body": "BigUint64Array"}


def field_type(field, type_):
    """In TypeScript, of a struct's field."""
    kind = type_["kind"]
    if kind in ("scalar", "handle"):
        return "bigint" if layout_type(field, type_) == "big" else "number"
    if kind == "struct":
        return class_name(type_["name"])
    if kind == "array":
        if type_["of"].get("name") == "char":
            return "string"
        return f"{field_type(field, type_['of'])}[]"
    if kind == "pointer":
        to = type_["to"]
        if to["kind"] in ("scalar", "handle") and to["name"] in POINTED:
            return POINTED[to["name"]]
        if to["kind"] == "struct":
            return class_name(to["name"])
        if to.get("name") == "lr_asset":
            return "Asset"
    return "number"  # an address


def raw_type(type_):
    if type_["kind"] == "scalar":
        return {"void": "void", "u64": "bigint", "i64": "bigint"}.get(type_["name"], "number")
    if type_["kind"] == "handle":
        return "bigint" if type_["of"] in ("u64", "i64") else "number"
    return "number"  # an address


def types(model):
    lines = [NOTICE, "import type { Asset } from '../../langevin_rigid.mjs';", "", "/** Constants of the C header, without LR_. */",
             "export declare const LR: {"]
    for c in model["constants"]:
        lines += comment(c["doc"], "  ") + [f"  readonly {c['name'].removeprefix('LR_')}: {number(c)};"]
    lines += ["};", ""]
    for struct in model["structs"]:
        lines += comment(struct["doc"]) + [f"export interface {class_name(struct['name'])} {{"]
        for field in filter(is_kept, struct["fields"]):
            type_ = field["type"]
            said = field["doc"] or field["about"]
            if type_["kind"] == "array" and type_["of"].get("name") != "char":
                said = f"{type_['count']} elements. {said}".strip()
            lines += comment(said, "  ") + [f"  {camel(field['name'])}: {field_type(field, type_)};"]
        lines += ["}", ""]
    lines += ["/** The C functions as the module exports them: addresses are numbers, 64 bits are bigints. */",
              "export interface RawFunctions {"]
    for function in model["functions"]:
        said = "\n".join(filter(None, [function["doc"], function["returns"]]))
        arguments = ", ".join(f"{p['name']}: {raw_type(p['type'])}" for p in function["parameters"])
        lines += comment(said, "  ") + [f"  {function['name']}({arguments}): {raw_type(function['result'])};"]
    return "\n".join(lines + ["}", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    check = parser.parse_args().check
    model = api_model.read(target="wasm32-unknown-unknown")
    stale = []
    for name, text in (("api.mjs", javascript(model)), ("api.d.mts", types(model))):
        path = OUT / name
        if path.exists() and path.read_text(encoding="utf-8") == text:
            continue
        stale.append(name)
        if not check:
            OUT.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    if check and stale:
        sys.exit(f"not what the header says: {', '.join(stale)}; run bindings/generator/javascript.py")


if __name__ == "__main__":
    main()
