#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the generated files of bindings/python from the public header: `_native.py` (ctypes), `enums.py`, `_options.py` (types
of keywords), `_records.py`, `_plain.py` (plain getters and setters), `_version.py`.

    python.py [--check]     --check writes nothing, and fails if a file is out of date
"""
import re
import sys

import output
import plain

OUT = "bindings/python/langevin_rigid"
HEAD = '# SPDX-License-Identifier: MIT\n# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.\n'

CTYPES = {"void": "None", "char": "ctypes.c_char", "f32": "ctypes.c_float", "f64": "ctypes.c_double",
          **{f"{s}{b}": f"ctypes.c_{'u' if s == 'u' else ''}int{b}" for s in "iu" for b in (8, 16, 32, 64)}}
HINTS = {"char": "str", "f32": "float", "f64": "float"}

# Functions of `plain` that wrappers have by hand, in another way.
HAND = {"lr_world_set_uniform_wind", "lr_world_set_water", "lr_world_set_events", "lr_batch_set_aerodynamics", "lr_body_set_state"}
# Structs with records or keywords beyond those of `plain`.
RECORDS = {"lr_asset_info", "lr_batch_rules", "lr_emitter_desc", "lr_water_desc"}
OPTIONS = {"lr_aerodynamics", "lr_batch_desc", "lr_body_state", "lr_collider_desc", "lr_collider_motion", "lr_material",
           "lr_ellipsoid_desc", "lr_kill_volume", "lr_recording_desc", "lr_rigid_desc", "lr_water_desc", "lr_turbulence_table", "lr_wave",
           "lr_world_desc", "lr_gusts_desc", "lr_vortex_desc", "lr_blower_desc", "lr_turbulence_desc", "lr_wind_grid_desc", "lr_ground_wind_desc"}
# Fields that are parameters of their own, or that follow from other fields.
GIVEN_OTHERWISE = {
    "lr_batch_desc": {"asset", "capacity"}, "lr_world_desc": {"allocator", "log", "log_user", "jobs"},
    "lr_collider_desc": {"kind", "vertex_count", "triangle_count", "counts"},
    "lr_recording_desc": {"write", "user"}, "lr_turbulence_table": {"count"}, "lr_body_state": {"noise_seed", "sleep_state"},
}
ENUM_OF = {}  # by constant: the prefix that its enum's members share, the class, whether members are bits, its text
RESERVED = re.compile(r"struct_size|reserved(_\d+)?$")


def class_name(name):
    """The Python class of a typedef of the header."""
    return "".join(word.capitalize() for word in name.removeprefix("lr_").split("_"))


def options_name(struct):
    return class_name(struct.removesuffix("_desc")) + "Options"


def hidden(struct):
    """Fields that are no keywords: array lengths follow from the arrays."""
    names = {f["name"] for f in struct["fields"]}
    counts = {name for name in names if name.endswith("_count") and name.removesuffix("count").rstrip("_") + "s" in names}
    return GIVEN_OTHERWISE.get(struct["name"], set()) | counts


def plain_calls(model):
    return [call for call in plain.calls(model, HAND) if not call["pointers"]]


def learn(model):
    for e in model["enums"]:
        entry = (e["prefix"], class_name(e["name"]), e["of"] == "u32", e["doc"].split("\n\n")[0] or class_name(e["name"]) + ".")
        ENUM_OF.update({constant["name"]: entry for constant in e["members"]})


def field_enum(field):
    typed = field["type"].get("enum")
    return class_name(typed) if typed else None


def member(name, prefix, enum):
    short = name.replace("LR_ERROR_", "LR_") if enum == "Status" else name
    short = short[len("LR_" if enum == "Status" else prefix):]
    if short[0].isdigit():
        short = "MATRIX_" + short
    return short


def references(text):
    """Replaces names of C constants in a text by enumerations and their members."""
    def name(match):
        word = match.group(0)
        if word in ENUM_OF:
            prefix, enum, _, _ = ENUM_OF[word]
            return f"`{enum}.{member(word, prefix, enum)}`"
        if word.endswith("*"):
            return next((f"`{enum}`" for prefix, enum, _, _ in ENUM_OF.values() if prefix == word[:-1]), word)
        return f"`{word[3:]}`" if word.startswith("LR_MAX_") else word
    return re.sub(r"\bLR_[A-Z0-9_]+\*?", name, text)


def quoted(text, indent):
    """A docstring with the lines of a text."""
    text = text.strip().replace("\\", "\\\\").replace('"""', '\\"\\"\\"')
    lines = text.split("\n")
    body = "\n".join([lines[0]] + [(indent + line).rstrip() for line in lines[1:]])
    if body.endswith('"'):
        body += " "
    return f'{indent}"""{body}{chr(10) + indent if len(lines) > 1 else ""}"""'


def ctype(type_):
    kind = type_["kind"]
    if kind == "scalar":
        return CTYPES[type_["name"]]
    if kind == "handle":
        return CTYPES[type_["of"]]
    if kind in ("struct", "opaque", "callback"):
        return type_["name"]
    if kind == "array":
        return f"{ctype(type_['of'])} * {type_['count']}"
    if kind == "function":
        return function_type(type_)
    if kind == "pointer":
        to = type_["to"]
        if to["kind"] == "scalar" and to["name"] == "void":
            return "ctypes.c_void_p"
        if to["kind"] == "scalar" and to["name"] == "char":
            return "ctypes.c_char_p"
        return f"ctypes.POINTER({ctype(to)})"
    raise SystemExit(f"python.py: no ctypes for {type_}")


def function_type(signature):
    parts = [ctype(signature["result"])] + [ctype(p["type"]) for p in signature["parameters"]]
    return f"ctypes.CFUNCTYPE({', '.join(parts)})"


def declaration(function):
    """The C declaration of a function, for its docstring."""
    def c(type_):
        kind = type_["kind"]
        if kind == "pointer":
            return f"{'const ' if type_['const'] else ''}{c(type_['to'])}*"
        if kind in ("scalar",):
            name = type_.get("enum") or type_["name"]
            return {"f32": "float", "f64": "double"}.get(name) or \
                (name if name in ("void", "char") else re.sub(r"^([iu])(\d+)$", lambda m: ("u" if m[1] == "u" else "") + f"int{m[2]}_t", name))
        return type_["name"]
    return f"{c(function['result'])} {function['name']}({', '.join(c(p['type']) + ' ' + p['name'] for p in function['parameters'])})"


def field_line(field):
    words = " ".join(x for x in (field["about"], field["doc"]) if x)
    return f"{field['name']}: {' '.join(words.split())}" if words else field["name"]


def native(model):
    version = model["version"]
    out = [HEAD, '"""The C API for ctypes: types, constants and prototypes of every function, under their C names."""',
           "# flake8: noqa", "import ctypes", "",
           f"VERSION = ({version['major']}, {version['minor']}, {version['patch']})  # of the header behind this file", ""]
    for c in model["constants"]:
        out.append(f"{c['name']} = {c['value']}")
    out.append("")
    for name in model["opaque"]:
        out += ["", f"class {name}(ctypes.Structure):", '    """Used only through pointers."""', ""]

    callbacks = {c["name"]: c for c in model["callbacks"]}
    done = set(model["opaque"])

    def needs(type_):
        if type_["kind"] in ("struct", "callback"):
            yield type_["name"]
        for key in ("to", "of", "result"):
            if isinstance(type_.get(key), dict):
                yield from needs(type_[key])
        for p in type_.get("parameters", []):
            yield from needs(p["type"])

    def emit_callback(c):
        for need in [n for p in c["parameters"] for n in needs(p["type"])]:
            emit(need)
        out.extend(["", f"{c['name']} = {function_type(c)}", f"{c['name']}.__doc__ = {quoted(c['doc'], '')}", ""])

    def emit_struct(s):
        for need in [n for f in s["fields"] for n in needs(f["type"])]:
            emit(need)
        out.extend(["", f"class {s['name']}(ctypes.Structure):"])
        doc = s["doc"] or f"{s['name']}: {s['size']} bytes."
        out.append(quoted(doc, "    "))
        out.append("    _fields_ = [")
        for f in s["fields"]:
            out.append(f"        ({f['name']!r}, {ctype(f['type'])}),")
        out.extend(["    ]", ""])

    def emit(name):
        if name in done:
            return
        done.add(name)
        if name in callbacks:
            emit_callback(callbacks[name])
        else:
            emit_struct(next(s for s in model["structs"] if s["name"] == name))

    for name in list(callbacks) + [s["name"] for s in model["structs"]]:
        emit(name)

    out += ["", "# Texts of fields, by struct.", "FIELD_DOCS = {"]
    for s in model["structs"]:
        out.append(f"    {s['name']!r}: {{")
        for f in s["fields"]:
            if not RESERVED.match(f["name"]):
                words = " ".join(" ".join(x for x in (f["about"], f["doc"]) if x).split())
                out.append(f"        {f['name']!r}: {references(words)!r},")
        out.append("    },")
    out += ["}", "", "# The `_init` function of each struct that has one.", "INITS = {"]
    out += [f"    {s['name']!r}: {s['init']!r}," for s in model["structs"] if s["init"]]
    out += ["}", "", "# name: (result, parameters, their names, text)", "PROTOTYPES = {"]
    for f in model["functions"]:
        out.append(f"    {f['name']!r}: (")
        out.append(f"        {ctype(f['result'])},")
        out.append(f"        [{', '.join(ctype(p['type']) for p in f['parameters'])}],")
        out.append(f"        {tuple(p['name'] for p in f['parameters'])!r},")
        text = [declaration(f)]
        if f["doc"]:
            text += ["", f["doc"]]
        said = [f"{p['name']}: {' '.join(p['doc'].split())}" for p in f["parameters"] if p["doc"]]
        if said:
            text += [""] + said
        if f["returns"]:
            text += ["", "Returns " + " ".join(f["returns"].split())]
        if f["threads"]:
            text += [f["threads"]]
        out.append(quoted("\n".join(text), "        ").lstrip(" ").join(["        ", ","]))
        out.append("    ),")
    out += ["}", "", "",
            "def bind(library):",
            '    """Sets types and docstring of every function of a loaded library."""',
            "    for name, (result, parameters, _, text) in PROTOTYPES.items():",
            "        function = getattr(library, name)",
            "        function.restype = result",
            "        function.argtypes = parameters",
            "        function.__doc__ = text",
            "    return library", ""]
    return "\n".join(out)


def enums(model):
    found = {}
    for c in model["constants"]:
        if c["name"] not in ENUM_OF:
            continue
        prefix, enum, bits, about = ENUM_OF[c["name"]]
        entry = found.setdefault(enum, {"bits": bits, "about": "", "members": []})
        entry["about"] = entry["about"] or about
        entry["members"].append((member(c["name"], prefix, enum), c["value"], " ".join(c["doc"].split())))
    limits = [c for c in model["constants"] if c["name"] not in ENUM_OF]
    out = [HEAD, '"""Constants of the library, as enumerations."""', "from enum import IntEnum, IntFlag", "",
           "__all__ = [", *[f"    {name!r}," for name in sorted(found) + [c['name'][3:] for c in limits]], "]", ""]
    for c in limits:
        words = " ".join(c["doc"].split())
        out.append(f"{c['name'][3:]} = {c['value']}" + (f"  # {words}" if words else ""))
    out.append("")
    for name, entry in found.items():
        out += ["", f"class {name}({'IntFlag' if entry['bits'] else 'IntEnum'}):", f'    """{entry["about"]}"""']
        for short, value, words in entry["members"]:
            out.append(f"    {short} = {value}" + (f"  # {references(words)}" if words else ""))
        out.append("")
    return "\n".join(out)


def version(model):
    numbers = ".".join(str(model["version"][part]) for part in ("major", "minor", "patch"))
    return f'{HEAD}\n"""Version of this package: that of the header."""\n__version__ = "{numbers}"\n'


def hint(type_, reading):
    kind = type_["kind"]
    if kind == "scalar":
        return HINTS.get(type_["name"], "int")
    if kind == "handle":
        return "int"
    if kind == "array":
        if type_["of"].get("name") == "char":
            return "str"
        if type_["of"]["kind"] == "struct" and not reading:
            return f"Sequence[{options_name(type_['of']['name'])}]"
        return "NDArray[Any]" if reading else "ArrayLike"
    return "NDArray[Any]" if reading else "Any"


def option_types(model):
    options = OPTIONS | {c["struct"] for c in plain_calls(model) if c["verb"] == "set" and c["struct"]}
    out = [HEAD, '"""Types of keywords for calls: only type checkers read them."""', "from __future__ import annotations", "",
           "from typing import TYPE_CHECKING, Any, Sequence, TypedDict", "", "if TYPE_CHECKING:", "    from numpy.typing import ArrayLike", ""]
    for s in (s for s in model["structs"] if s["name"] in options):
        out += ["", f"class {options_name(s['name'])}(TypedDict, total=False):", f'    """Keywords for {s["name"]}."""']
        for f in s["fields"]:
            if not RESERVED.match(f["name"]) and f["name"] not in hidden(s):
                out.append(f"    {f['name']}: {hint(f['type'], False)}")
        out.append("")
    return "\n".join(out)


def record_types(model):
    records = RECORDS | {c["struct"] for c in plain_calls(model) if c["verb"] == "get" and c["struct"]}
    enums = {field_enum(f) for s in model["structs"] if s["name"] in records for f in s["fields"] if field_enum(f)}
    out = [HEAD, '"""Records that calls return."""', "from __future__ import annotations", "", "from typing import TYPE_CHECKING, Any", "",
           "from ._record import Record", f"from .enums import {', '.join(sorted(enums))}", "",
           "if TYPE_CHECKING:", "    from numpy.typing import NDArray", ""]
    for s in (s for s in model["structs"] if s["name"] in records):
        struct, name = s["name"], class_name(s["name"].removesuffix("_desc"))
        used = [f for f in s["fields"] if not RESERVED.match(f["name"])]
        text = (s["doc"] or f"Values of {struct}.") + "\n\n" + "\n".join(field_line(f) for f in used)
        out += ["", f"class {name}(Record):", quoted(references(text), "    "), f"    __slots__ = {tuple(f['name'] for f in used)!r}"]
        out += [f"    {f['name']}: {field_enum(f) or hint(f['type'], True)}" for f in used]
        if enums := {f["name"]: field_enum(f) for f in used if field_enum(f)}:
            out.append(f"    _enums = {{{', '.join(f'{name!r}: {enum}' for name, enum in enums.items())}}}")
        out.append("")
    return "\n".join(out)


PLAIN = '''


class Plain:
    """Makes calls by `_ask` and `_change`, which put the called object before the arguments."""

    if TYPE_CHECKING:
        def _ask(self, name: str, *arguments: Any) -> None: ...
        def _change(self, name: str, *arguments: Any) -> None: ...

    def _set(self, name: str, struct: Any, fields: Mapping[str, Any]) -> None:
        """Passes null if there are no fields."""
        keep: List[Any] = []
        given = any(value is not None for value in fields.values())
        self._change(name, ctypes.byref(make(struct, fields, keep)) if given else None)


class OfWorld(Plain):
    """Makes calls on an object with a handle in a world."""

    if TYPE_CHECKING:
        world: Any
        id: int

    def _ask(self, name: str, *arguments: Any) -> None:
        self.world._ask(name, self.id, *arguments)

    def _change(self, name: str, *arguments: Any) -> None:
        self.world._change(name, self.id, *arguments)
'''


def parameter_enum(parameter):
    type_ = parameter["type"]["to"] if parameter["type"]["kind"] == "pointer" else parameter["type"]
    return class_name(type_["enum"]) if "enum" in type_ else None


def given(parameter):
    """The type hint of a number, and the expression to pass."""
    name, scalar = parameter["name"], parameter["type"]["name"]
    if name == "enabled":
        return "bool", "int(enabled)"
    return ("float", f"float({name})") if scalar in ("f32", "f64") else ("int", f"integer({name}, {CTYPES[scalar]}, {name!r})")


def plain_getter(call, setter):
    name, of_body = call["function"]["name"], call["owner"] == "body"
    text = references(plain.summary(call["function"]))
    arguments = '"' + name + '", ' + ("int(body), " if of_body else "")
    if call["struct"]:
        type_ = class_name(call["struct"])
        body = [f"value = init(native.{call['struct']})", f"self._ask({arguments}ctypes.byref(value))", f"return {type_}.read(value)"]
    else:
        [value] = call["values"]
        scalar, enum = value["type"]["to"]["name"], parameter_enum(value)
        type_ = "bool" if value["name"] == "enabled" else enum or HINTS.get(scalar, "int")
        body = [f"value = {CTYPES[scalar]}()", f"self._ask({arguments}ctypes.byref(value))",
                f"return {'bool' if type_ == 'bool' else enum or ''}(value.value)" if type_ == "bool" or enum else "return value.value"]
    property_ = [] if of_body else ["@property"]
    lines = property_ + [f"def {call['name']}(self{', body: int' if of_body else ''}) -> {type_}:", f'    """{text}"""', *("    " + b for b in body)]
    if setter and not setter["struct"]:
        hint_, handed = given(setter["values"][0])
        handed = handed.replace(setter["values"][0]["name"], "value", 1) if handed != "int(enabled)" else "int(value)"
        lines += ["", f"@{call['name']}.setter", f"def {call['name']}(self, value: {hint_}) -> None:",
                  f'    self._change("{setter["function"]["name"]}", {handed})']
    return lines


def plain_setter(call, model):
    name, function = call["name"], call["function"]
    text = references(plain.summary(function))
    if call["struct"]:
        text += {"clear": " Without keywords, removes the setting.", "reset": " Without keywords, restores the initial setting.", None: ""}[function["null"]]
        struct = next(s for s in model["structs"] if s["name"] == call["struct"])
        hide = "".join(f', "{n}"' for n in sorted(hidden(struct)))
        keyword = call["values"][0]["name"]
        lines = [f'@takes("{call["struct"]}"{hide})', f'def set_{name}(self, **{keyword}: "Unpack[{options_name(call["struct"])}]") -> None:']
        call_ = f'self._set("{function["name"]}", native.{call["struct"]}, {keyword})' if function["null"] else \
            f'self._change("{function["name"]}", ctypes.byref(make(native.{call["struct"]}, {keyword}, [])))'
        return lines + [f'    """{text}"""', "    " + call_]
    numbers = [given(p) for p in call["values"]]
    parameters = "".join(f", {p['name']}: {hint_}" for (hint_, _), p in zip(numbers, call["values"]))
    said = [f"{p['name']}: {' '.join(references(p['doc']).split())}" for p in call["values"] if p["doc"]]
    lines = [f"def set_{name}(self{parameters}) -> None:", quoted("\n\n".join([text, *said]), "    ")]
    return lines + [f'    self._change("{function["name"]}"{"".join(", " + handed for _, handed in numbers)})']


def plain_text(model):
    calls, used, body = plain_calls(model), set(), []
    for class_, owners, base in (("BatchPlain", ("batch",), "(OfWorld)"), ("ColliderPlain", ("collider",), "(OfWorld)"),
                                 ("WorldPlain", ("world", "body"), "(Plain)")):
        body += ["", f"class {class_}{base}:", f'    """Plain getters and setters of `{class_.removesuffix("Plain")}`."""', ""]
        for call in (c for c in calls if c["owner"] in owners):
            other = plain.partner(calls, call)
            if call["verb"] == "set" and not call["struct"] and other:
                continue
            lines = plain_getter(call, other) if call["verb"] == "get" else plain_setter(call, model)
            body += [("    " + line).rstrip() for line in "\n".join(lines).split("\n")] + [""]
    text = "\n".join(body)
    def names(found):
        return sorted(n for n in found if re.search(rf"\b{n}\b", text))
    records = names({class_name(c["struct"]) for c in calls if c["struct"]})
    options = names({options_name(c["struct"]) for c in calls if c["struct"]})
    enums = names({entry[1] for entry in ENUM_OF.values()} - set(records))
    enums = [e for e in enums if re.search(rf"(-> |return ){e}\b", text)]
    head = [HEAD, '"""Getters and setters of a single call: bases of the hand-written classes."""',
            "from __future__ import annotations", "", "import ctypes", "from typing import TYPE_CHECKING, Any, List, Mapping", "",
            "from . import _native as native", f"from ._records import {', '.join(records)}", "from ._structs import init, integer, make, takes",
            *([f"from .enums import {', '.join(enums)}"] if enums else []), "", "if TYPE_CHECKING:",
            "    from typing_extensions import Unpack", "", f"    from ._options import {', '.join(options)}"]
    return "\n".join(head) + PLAIN + "\n" + text


def files(model):
    learn(model)
    return {f"{OUT}/{name}": text for name, text in (
        ("_native.py", native(model)), ("_version.py", version(model)), ("enums.py", enums(model)), ("_options.py", option_types(model)),
        ("_records.py", record_types(model)), ("_plain.py", plain_text(model)))}


def main():
    return output.run(__doc__, files)


if __name__ == "__main__":
    sys.exit(not main())
