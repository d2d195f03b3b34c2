#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes what bindings/python has from the public header: `_native.py` (ctypes), `enums.py`, `_fields.py` (types of options and of
what is read back), `_version.py`.

    python.py [--check] [--out DIR]     --check writes nothing, and exits with 1 where a file is not what it would write
"""
import argparse
import difflib
import pathlib
import re
import sys

import api_model

OUT = pathlib.Path(__file__).resolve().parents[1] / "python" / "langevin_rigid"
HEAD = '# SPDX-License-Identifier: MIT\n# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.\n'

CTYPES = {"void": "None", "char": "ctypes.c_char", "f32": "ctypes.c_float", "f64": "ctypes.c_double",
          **{f"{s}{b}": f"ctypes.c_{'u' if s == 'u' else ''}int{b}" for s in "iu" for b in (8, 16, 32, 64)}}
HINTS = {"char": "str", "f32": "float", "f64": "float"}

# Families of constants: prefix, enumeration, whether its members are bits, what it is. The longest prefix that fits counts.
FAMILIES = [
    ("LR_LOG_", "LogLevel", False, "How grave a message is."),
    ("LR_SIMD_", "SimdTarget", False, "Instruction sets, all of which give the same bits."),
    ("LR_ASSET_", "AssetFlags", True, "What is special about an asset."),
    ("LR_WIND_", "WindKind", False, "The uniform part of the wind."),
    ("LR_WIND_SOURCE_", "WindSourceKind", False, "Kinds of wind sources."),
    ("LR_WIND_OUTSIDE_", "WindOutside", False, "What a wind grid is outside its samples."),
    ("LR_LOADS_", "Loads", False, "What the fluid does to the bodies of a batch."),
    ("LR_CLOCK_", "Clock", False, "What turbulence goes by."),
    ("LR_TABLE_", "TableEnd", False, "What comes after the last sample of a turbulence table."),
    ("LR_INTEGRATOR_", "Integrator", False, "How motion is integrated."),
    ("LR_TRANSFORM_", "Transform", False, "Formats of transforms."),
    ("LR_REST_", "Rest", False, "Whether a body is at rest."),
    ("LR_FORCE_MODE_", "ForceMode", False, "What a force's numbers are."),
    ("LR_FRAME_", "Frame", False, "The frame of a force."),
    ("LR_FORCE_", "ForceFlags", True, "Where a force acts."),
    ("LR_COLLIDER_", "ColliderKind", False, "Shapes of colliders."),
    ("LR_MOVE_", "MoveMode", False, "How a collider moves."),
    ("LR_CONTACT_", "EventKind", False, "What happened to a body."),
    ("LR_CONTACT_NEVER_REST", "ContactFlags", True, "How bodies of a batch meet colliders."),
    ("LR_BODY_", "EventKind", False, ""),
    ("LR_EVENTS_", "EventKinds", True, "Which events are kept."),
    ("LR_RAY_", "RayFlags", True, "What a ray can hit."),
    ("LR_OVERLAP_", "OverlapShape", False, "Where bodies are looked for."),
    ("LR_END_", "EndAction", False, "What becomes of bodies that end."),
    ("LR_FAULT_", "FaultPolicy", False, "What becomes of bodies that have left physics."),
    ("LR_VOLUME_", "VolumeShape", False, "Shapes of kill volumes."),
    ("LR_KILL_", "KillSide", False, "On which side of a kill volume bodies end."),
    ("LR_EMIT_", "EmitShape", False, "Where bodies are born."),
    ("LR_POSE_", "Pose", False, "How bodies lie when they are born."),
    ("LR_CHECK_", "WorldChecks", True, "Misuse that is found at run time."),
    ("LR_RECORD_", "RecordingFlags", True, "Of a recording."),
    ("LR_MAX_", None, False, ""),
    ("LR_OK", "Status", False, "What a call says: exceptions have it as `status`."),
    ("LR_ERROR_", "Status", False, ""),
]

# Structs that are read back: their class, frozen and with names as in C.
RECORDS = {
    "lr_aerodynamics": "Aerodynamics", "lr_asset_info": "AssetInfo", "lr_world_info": "WorldInfo",
    "lr_step_report": "StepReport", "lr_batch_pace": "BatchPace", "lr_body_state": "BodyState",
    "lr_collider_state": "ColliderState", "lr_batch_contact": "BatchContact", "lr_batch_events": "BatchEvents",
}
# Structs that calls take as keywords: the type of those.
OPTIONS = {
    "lr_aerodynamics": "AerodynamicsOptions", "lr_batch_contact": "ContactOptions", "lr_batch_desc": "BatchOptions",
    "lr_batch_force": "BatchForceOptions", "lr_batch_rules": "RulesOptions",
    "lr_body_state": "StateOptions", "lr_collider_desc": "ColliderOptions",
    "lr_collider_motion": "MotionOptions", "lr_collider_surface": "ColliderSurfaceOptions",
    "lr_ellipsoid_desc": "EllipsoidOptions", "lr_emitter_desc": "EmitterOptions", "lr_kill_volume": "KillVolumeOptions",
    "lr_load_gains": "LoadGainsOptions", "lr_recording_desc": "RecordingOptions", "lr_rigid_desc": "RigidOptions", "lr_surface_desc": "SurfaceOptions",
    "lr_turbulence_table": "TurbulenceTableOptions", "lr_wave": "WaveOptions", "lr_wind_source_desc": "WindSourceOptions",
    "lr_world_desc": "WorldOptions",
}
# Fields that callers give otherwise: as parameters of their own, or by what follows from others.
GIVEN_OTHERWISE = {
    "lr_batch_desc": {"asset", "capacity"}, "lr_world_desc": {"allocator", "log", "log_user", "jobs"},
    "lr_collider_desc": {"kind", "vertex_count", "triangle_count", "counts"}, "lr_wind_source_desc": {"kind"},
    "lr_surface_desc": {"wave_count"}, "lr_recording_desc": {"write", "user"}, "lr_turbulence_table": {"count"}, "lr_body_state": {"key", "resting"},
}
# Enumerations that are read back as such.
READ_AS = {"simd_target": "SimdTarget", "resting": "Rest"}
RESERVED = re.compile(r"struct_size|reserved(_\d+)?$")


def family(name):
    fitting = [f for f in FAMILIES if name.startswith(f[0])]
    if not fitting:
        raise SystemExit(f"python.py: no family for the constant {name}: add one to FAMILIES")
    return max(fitting, key=lambda f: len(f[0]))


def member(name, prefix, enum):
    if enum == "EventKind":
        return name.replace("LR_CONTACT_", "CONTACT_").replace("LR_BODY_", "")
    if enum == "ContactFlags":
        return "NEVER_REST"
    short = name.replace("LR_ERROR_", "LR_") if enum == "Status" else name
    short = short[len("LR_" if enum == "Status" else prefix):]
    if short[0].isdigit():
        short = "MATRIX_" + short
    return "STILL" if short == "NONE" and enum == "WindKind" else short


def references(text):
    """Names of enumerations and their members instead of those of C constants, where a text speaks of one."""
    def name(match):
        word = match.group(0)
        if word.endswith("*"):
            found = [f for f in FAMILIES if f[0] == word[:-1] and f[1]]
            return f"`{found[0][1]}`" if found else word
        fitting = [f for f in FAMILIES if word.startswith(f[0])]
        if not fitting:
            return word
        prefix, enum, _, _ = max(fitting, key=lambda f: len(f[0]))
        return f"`{enum}.{member(word, prefix, enum)}`" if enum else f"`{word[3:]}`"
    return re.sub(r"\bLR_[A-Z0-9_]+\*?", name, text)


def quoted(text, indent):
    """A docstring of a text, its lines as they are."""
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
    """How C declares a function, for its docstring."""
    def c(type_):
        kind = type_["kind"]
        if kind == "pointer":
            return f"{'const ' if type_['const'] else ''}{c(type_['to'])}*"
        if kind in ("scalar",):
            name = type_["name"]
            return {"f32": "float", "f64": "double"}.get(name) or \
                (name if name in ("void", "char") else re.sub(r"^([iu])(\d+)$", lambda m: ("u" if m[1] == "u" else "") + f"int{m[2]}_t", name))
        return type_["name"]
    return f"{c(function['result'])} {function['name']}({', '.join(c(p['type']) + ' ' + p['name'] for p in function['parameters'])})"


def field_line(field):
    words = " ".join(x for x in (field["about"], field["doc"]) if x)
    return f"{field['name']}: {' '.join(words.split())}" if words else field["name"]


def native(model):
    version = model["version"]
    out = [HEAD, '"""The C API as ctypes sees it: types, constants, and prototypes of every function. All names are those of C."""',
           "# flake8: noqa", "import ctypes", "",
           f"VERSION = ({version['major']}, {version['minor']}, {version['patch']})  # of the header that this was made from", ""]
    for c in model["constants"]:
        out.append(f"{c['name']} = {c['value']}")
    out.append("")
    for name in model["opaque"]:
        out += ["", f"class {name}(ctypes.Structure):", '    """Seen through pointers only."""', ""]

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

    out += ["", "# What each field is, by struct.", "FIELD_DOCS = {"]
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
            '    """Gives every function of a loaded library its types and its text."""',
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
        prefix, enum, bits, about = family(c["name"])
        if enum is None:
            continue
        entry = found.setdefault(enum, {"bits": bits, "about": "", "members": []})
        entry["about"] = entry["about"] or about
        entry["members"].append((member(c["name"], prefix, enum), c["value"], " ".join(c["doc"].split())))
    limits = [c for c in model["constants"] if family(c["name"])[1] is None]
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
        return "np.ndarray" if reading else "ArrayLike"
    return "np.ndarray" if reading else "Any"


def fields(model):
    structs = {s["name"]: s for s in model["structs"]}
    out = [HEAD, '"""Types of what calls take as keywords, and of what they read back."""', "from __future__ import annotations", "",
           "from typing import TYPE_CHECKING, Any, TypedDict", "", "import numpy as np", "", "from ._record import Record", "from .enums import Rest, SimdTarget", "",
           "if TYPE_CHECKING:", "    from numpy.typing import ArrayLike", ""]
    for struct, name in OPTIONS.items():
        s = structs[struct]
        out += ["", f"class {name}(TypedDict, total=False):", f'    """Keywords for {struct}."""']
        for f in s["fields"]:
            if not RESERVED.match(f["name"]) and f["name"] not in GIVEN_OTHERWISE.get(struct, ()):
                out.append(f"    {f['name']}: {hint(f['type'], False)}")
        out.append("")
    for struct, name in RECORDS.items():
        s = structs[struct]
        used = [f for f in s["fields"] if not RESERVED.match(f["name"])]
        text = (s["doc"] or f"What {struct} says.") + "\n\n" + "\n".join(field_line(f) for f in used)
        out += ["", f"class {name}(Record):", quoted(references(text), "    "), f"    __slots__ = {tuple(f['name'] for f in used)!r}"]
        out += [f"    {f['name']}: {READ_AS.get(f['name']) or hint(f['type'], True)}" for f in used]
        out.append("")
    return "\n".join(out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--out", type=pathlib.Path, default=OUT)
    options = parser.parse_args()
    model = api_model.read()
    different = False
    for name, text in (("_native.py", native(model)), ("_version.py", version(model)), ("enums.py", enums(model)), ("_fields.py", fields(model))):
        path = options.out / name
        if not options.check:
            path.write_text(text, encoding="utf-8")
            continue
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        if old != text:
            different = True
            sys.stderr.writelines(list(difflib.unified_diff(old.splitlines(True), text.splitlines(True), str(path), "generated"))[:40])
            print(f"\n{path}: not what the header gives: run bindings/generator/python.py", file=sys.stderr)
    sys.exit(1 if different else 0)


if __name__ == "__main__":
    main()
