# SPDX-License-Identifier: MIT
"""Getters and setters with the same form in all languages: lr_CLASS_set_NAME or lr_CLASS_get_NAME of a world, or of a batch, body or
collider in it, with numbers, or with one struct that has a struct_size."""
import re

BY_HAND = {"lr_world_get_uniform_wind"}  # fills three floats, which its type does not show
OF_WORLD = ("world", "batch", "body", "collider")


def has_pointers(model, struct):
    """Whether a struct has pointers, which a wrapper has to copy or keep alive."""
    fields = next(s for s in model["structs"] if s["name"] == struct)["fields"]
    types = [f["type"]["of"] if f["type"]["kind"] == "array" else f["type"] for f in fields]
    return any(t["kind"] in ("pointer", "callback", "function") or t["kind"] == "struct" and has_pointers(model, t["name"]) for t in types)


def summary(function):
    """The first sentence of its text, without its clause on null: wrappers have another call for that."""
    text = re.match(r"(.*?)(?:[.:](?:\s|$)|$)", " ".join(function["doc"].split())).group(1)
    return re.sub(r"; null \w+ .*", "", text) + "."


def calls(model, hand=()):
    """Lists them as {owner: a class of OF_WORLD, verb: set or get, name, function, struct: its name or None, pointers: of the struct,
    values: parameters}. hand: functions with hand-written wrappers, left out."""
    sized = {s["name"] for s in model["structs"] if s["init"]}
    for function in model["functions"]:
        match = re.fullmatch(rf"lr_({'|'.join(OF_WORLD)})_(set|get)_(\w+)", function["name"])
        if not match or function["name"] in BY_HAND.union(hand):
            continue
        owner, verb, name = match.groups()
        values = function["parameters"][1:]
        if owner != "world":
            handle, *values = values
            if handle["type"].get("name") != f"lr_{owner}":
                continue
        types = [v["type"] for v in values]
        if not types or any(t["kind"] == "pointer" and t["const"] != (verb == "set") for t in types):
            continue
        inner = [t["to"] if t["kind"] == "pointer" else t for t in types]
        struct = inner[0]["name"] if len(types) == 1 and types[0]["kind"] == "pointer" and inner[0].get("name") in sized else None
        numbers = all(t["kind"] == "scalar" for t in (types if verb == "set" else inner))
        if struct or numbers and (verb == "set" or len(types) == 1 and types[0]["kind"] == "pointer"):
            yield {"owner": owner, "verb": verb, "name": name, "function": function, "struct": struct, "values": values,
                   "pointers": bool(struct) and has_pointers(model, struct)}


def partner(all_calls, call):
    """The setter of a getter, and the other way round; None without a counterpart."""
    return next((c for c in all_calls if (c["owner"], c["name"]) == (call["owner"], call["name"]) and c is not call), None)
