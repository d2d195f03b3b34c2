# SPDX-License-Identifier: MIT
"""Compares a header's promises to compiled programs with another header: docs/maintainers/releases.md."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bindings" / "generator"))
import api_model  # noqa: E402

WIDE, NARROW = "x86_64-unknown-linux-gnu", "wasm32-unknown-unknown"


def text(type_):
    """A type as written in the header."""
    kind = type_["kind"]
    if kind == "pointer":
        return ("const " if type_["const"] else "") + text(type_["to"]) + "*"
    if kind == "array":
        return f"{text(type_['of'])}[{type_['count']}]"
    if kind == "function":
        return f"{text(type_['result'])}(*)({', '.join(text(p['type']) for p in type_['parameters'])})"
    return type_["name"]


def signature(function):
    return f"{text(function['result'])} ({', '.join(text(p['type']) for p in function['parameters'])})"


class Surface:
    """A header as tables from names to unchangeable properties."""

    def __init__(self, header):
        wide, narrow = (api_model.read(header, target) for target in (WIDE, NARROW))
        self.version = tuple(wide["version"][part] for part in ("major", "minor", "patch"))
        self.constants = {c["name"]: (c["value"], c["scalar"]) for c in wide["constants"]}
        self.functions = {f["name"]: signature(f) for f in wide["functions"]}
        self.callbacks = {c["name"]: signature(c) for c in wide["callbacks"]}
        self.handles = {h["name"]: h["of"] for h in wide["handles"]}
        self.opaque = {name: "opaque" for name in wide["opaque"]}
        self.model = wide
        self.structs = {}
        for struct, other in zip(wide["structs"], narrow["structs"], strict=True):
            fields = [(f["name"], text(f["type"]), (f["offset"], f["size"], g["offset"], g["size"]))
                      for f, g in zip(struct["fields"], other["fields"], strict=True)]
            self.structs[struct["name"]] = {
                "sizes": (struct["size"], other["size"]), "alignments": (struct["alignment"], other["alignment"]),
                "fields": fields, "sized": fields[0][0] == "struct_size",
                "init": struct["init"]}
        inside = " ".join(type_ for s in self.structs.values() for _, type_, _ in s["fields"] if "*" not in type_)
        for name, struct in self.structs.items():
            # A struct within another struct, or within its arrays, gives that struct its size.
            struct["grows"] = struct["sized"] and name not in inside.replace("[", " ").split()


def compare_names(what, old, new, breaks, growth, gone):
    for name, value in old.items():
        if name not in new:
            breaks.append(f"{what} {name} is gone: {gone}")
        elif new[name] != value:
            breaks.append(f"{what} {name} was {value} and is {new[name]}")
    growth.extend(f"{what} {name} is new" for name in new if name not in old)


def compare_constants(old, new, breaks, growth):
    for name, (value, scalar) in old.items():
        if name not in new:
            breaks.append(f"constant {name} is gone: programs that name it no longer compile")
            continue
        now, scalar_now = new[name]
        if (now, scalar_now) == (value, scalar):
            continue
        # Compiled programs keep the old value, which must keep its meaning.
        wider = name.endswith("_ALL") and scalar_now == scalar == "u32" and now & value == value
        higher = name.startswith("LR_MAX_") and scalar_now == scalar and now > value
        (growth if wider or higher else breaks).append(
            f"constant {name} was {value} ({scalar}) and is {now} ({scalar_now})" +
            ("" if wider or higher else ": compiled programs keep the old value, and would mean something else by it"))
    growth.extend(f"constant {name} is new" for name in new if name not in old)


def compare_struct(name, old, new, breaks, growth):
    for index, (field, type_, place) in enumerate(old["fields"]):
        if index >= len(new["fields"]):
            breaks.append(f"struct {name}: field {field} is gone")
            continue
        field_now, type_now, place_now = new["fields"][index]
        if place_now != place:
            breaks.append(f"struct {name}: at the place of {field} (offset {place[0]}, {place[1]} bytes) is {field_now} (offset "
                          f"{place_now[0]}, {place_now[1]} bytes): compiled programs read and write the old places")
            return
        if (field_now, type_now) != (field, type_):
            taken = field.startswith("reserved") and field_now != field  # programs had to pass 0 before
            (growth if taken else breaks).append(f"struct {name}: field {field} ({type_}) has become {field_now} ({type_now})")
    more = new["fields"][len(old["fields"]):]
    for field, _, (offset, _, narrow, _) in more:
        if offset < old["sizes"][0]:
            breaks.append(f"struct {name}: the new field {field} at {offset} lies within the old size of {old['sizes'][0]} bytes, where "
                          "old programs have padding of any value")
        elif narrow < old["sizes"][1]:
            breaks.append(f"struct {name}: on wasm32 the new field {field} at {narrow} lies within the old size of {old['sizes'][1]} bytes, "
                          "where old programs have padding of any value: give it the struct's alignment")
        else:
            growth.append(f"struct {name}: field {field} is new, behind the old size of {old['sizes'][0]} bytes")
    if new["sizes"] != old["sizes"] and not (old["grows"] and more):
        breaks.append(f"struct {name} had {old['sizes'][0]} bytes and has {new['sizes'][0]}" +
                      ("" if old["grows"] else ": it has no struct_size by which the library could tell callers apart, or lies in others"))
    elif more and not old["grows"]:
        breaks.append(f"struct {name} must not get fields: it has no struct_size, or lies in others")
    if new["alignments"] != old["alignments"]:
        breaks.append(f"struct {name} was aligned to {old['alignments'][0]} bytes and is to {new['alignments'][0]}")


def compare(old, new):
    """Two lists of sentences: changes that break programs compiled with the old header, and harmless changes."""
    breaks, growth = [], []
    compare_names("function", old.functions, new.functions, breaks, growth, "programs that call it no longer start")
    compare_names("callback", old.callbacks, new.callbacks, breaks, growth, "programs that name it no longer compile")
    compare_names("handle", old.handles, new.handles, breaks, growth, "programs that name it no longer compile")
    compare_names("type", old.opaque, new.opaque, breaks, growth, "programs that name it no longer compile")
    compare_constants(old.constants, new.constants, breaks, growth)
    for name, struct in old.structs.items():
        if name in new.structs:
            compare_struct(name, struct, new.structs[name], breaks, growth)
        else:
            breaks.append(f"struct {name} is gone")
    growth.extend(f"struct {name} is new" for name in new.structs if name not in old.structs)
    return breaks, growth


def grown(old, new):
    """Structs whose only difference is additional fields at the end."""
    names = []
    for name, struct in old.structs.items():
        breaks, growth = [], []
        if struct["grows"] and name in new.structs:
            compare_struct(name, struct, new.structs[name], breaks, growth)
            if not breaks and len(new.structs[name]["fields"]) > len(struct["fields"]):
                names.append(name)
    return names


def layout_text(surface):
    """The table for check_layout.c."""
    lines = ["/* Made by tests/abi/check.py --renew. Numbers are those of 64-bit targets, then of wasm32.",
             " * GROWS(struct, size, alignment): callers size it. OURS: the library does, for callbacks. FIXED: has that size for ever.",
             " * FIELD(struct, field, offset, size) */"]
    for name, struct in surface.structs.items():
        (size, narrow), (align, narrow_align) = struct["sizes"], struct["alignments"]
        kind = "FIXED" if not struct["grows"] else "GROWS" if struct["init"] else "OURS"
        lines.append(f"{kind}({name}, {size}, {align}, {narrow}, {narrow_align})")
        lines += [f"FIELD({name}, {field}, {', '.join(map(str, place))})" for field, _, place in struct["fields"]]
    return "\n".join(lines) + "\n"
