#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the generated files of the WebAssembly package from the public header as wasm32 sees it: constants, layouts of structs,
TypeScript types, and the plain getters and setters of its classes.

    javascript.py [--check]     writes bindings/web/src/generated
"""
import re
import sys

import output
import plain

OUT = "bindings/web/src/generated"
NOTICE = "// Made by bindings/generator/javascript.py from include/langevin_rigid.h: changes here are lost.\n" \
         "// SPDX-License-Identifier: MIT\n"
# These have hand-written wrappers.
HAND = {"lr_world_set_uniform_wind", "lr_world_set_events", "lr_body_set_state"}
# 64-bit values that are compared or passed on are bigints; those used in arithmetic are numbers, and stay below 2^53.
WHOLE_WORDS = {"seed", "content_hash", "user"}


def camel(name):
    head, *rest = name.split("_")
    return head + "".join(word.capitalize() for word in rest)


def class_name(struct):
    return camel("x_" + struct.removeprefix("lr_"))[1:]


def is_kept(field):
    """Fields that users see."""
    return field["name"] != "struct_size" and not re.match(r"reserved(_\d+)?$", field["name"])


def layout_type(field, type_):
    """The layout type of a field: a scalar's name, a struct's, `char` or `pointer`."""
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


POINTED = {"f32": "Float32Array", "f64": "Float64Array", "u32": "Uint32Array", "i32": "Int32Array", "u64": "BigUint64Array", "lr_body": "BigUint64Array"}


def field_type(field, type_):
    """The TypeScript type of a struct's field."""
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


def plain_calls(model):
    """Calls by class."""
    calls = [call for call in plain.calls(model, HAND) if not call["pointers"]]
    for class_, owners in (("BatchPlain", ("batch",)), ("WorldPlain", ("world", "body", "collider"))):
        yield class_, [(call, plain.partner(calls, call)) for call in calls if call["owner"] in owners]


def plain_member(call, other):
    """(the member in JavaScript, its text, its TypeScript declaration: none for a setter that its getter covers)"""
    owner, name, function = call["owner"], call["name"], call["function"]["name"]
    to = "this.world" if owner == "batch" else "this"
    handle = {"world": "", "batch": ", this.handle"}.get(owner, f", {owner}")
    text = plain.summary(call["function"])
    if call["verb"] == "get":
        if call["struct"]:
            value, type_ = f"{to}.get('{call['struct']}', '{function}'{handle})", f"api.{class_name(call['struct'])}"
        else:
            [parameter] = call["values"]
            scalar = layout_type(parameter, parameter["type"]["to"])
            value, type_ = f"{to}.number('{scalar}', '{function}'{handle})", "bigint" if scalar == "big" else "number"
            if parameter["name"] == "enabled":
                value, type_ = value + " !== 0", "boolean"
        if owner in ("body", "collider"):
            return f"{camel(owner + '_' + name)}({owner}) {{ return {value}; }}", text, f"{camel(owner + '_' + name)}({owner}: bigint): {type_};"
        return f"get {camel(name)}() {{ return {value}; }}", text, f"{'' if other and not call['struct'] else 'readonly '}{camel(name)}: {type_};"
    names = [camel(p["name"]) for p in call["values"]]
    if call["struct"]:
        null = " | null" if call["function"]["null"] else ""
        return (f"set{class_name(name)}({names[0]}) {{ {to}.set('{call['struct']}', {names[0]}, '{function}'{handle}); }}",
                text + (" null undoes it." if null else ""), f"set{class_name(name)}({names[0]}: Input<api.{class_name(call['struct'])}>{null}): void;")
    types = ["boolean" if n == "enabled" else "number" if p["type"]["name"] != "u64" else "bigint | number" for n, p in zip(names, call["values"])]
    checks = [{"u64": "wholeWord", "f32": ""}.get(p["type"]["name"], "whole") for p in call["values"]]
    given = [f"{n} ? 1 : 0" if t == "boolean" else f"{check}({n}, '{n}')" if check else n for n, t, check in zip(names, types, checks)]
    made = f"{to}.call('{function}'{handle}, {', '.join(given)});"
    if other and len(names) == 1:
        return f"set {camel(name)}({names[0]}) {{ {made} }}", "", None
    typed = ", ".join(f"{n}: {t}" for n, t in zip(names, types))
    said = [f"{n}: {' '.join(p['doc'].split())}" for n, p in zip(names, call["values"]) if p["doc"]]
    return f"set{class_name(name)}({', '.join(names)}) {{ {made} }}", "\n".join([text, *said]), f"set{class_name(name)}({typed}): void;"


def plain_javascript(model):
    lines = [NOTICE, "import { whole, wholeWord } from '../heap.mjs';", ""]
    for class_, calls in plain_calls(model):
        lines += [f"export class {class_} {{", *("  " + plain_member(*call)[0] for call in calls), "}", ""]
    return "\n".join(lines)


def plain_types(model):
    lines = [NOTICE, "import type { Input } from '../../langevin_rigid.mjs';", "import type * as api from './api.mjs';", ""]
    for class_, calls in plain_calls(model):
        lines.append(f"export declare class {class_} {{")
        for _, text, declaration in (plain_member(*call) for call in calls):
            lines += comment(text, "  ") + ["  " + declaration] if declaration else []
        lines += ["}", ""]
    return "\n".join(lines)


def main():
    return output.run(__doc__, lambda model: {f"{OUT}/{name}": text for name, text in (
        ("api.mjs", javascript(model)), ("api.d.mts", types(model)), ("plain.mjs", plain_javascript(model)), ("plain.d.mts", plain_types(model)))},
        target="wasm32-unknown-unknown")


if __name__ == "__main__":
    sys.exit(not main())
