#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes the lists that the library, lr_replay and the tests take from the public header:

    src/api/structs.inc              structs with an init function
    src/api/status_texts.inc         texts of statuses
    src/tools/lr_replay/calls.inc       recorded calls, and whether lr_replay can repeat them by their types alone
    tests/api/calls.inc              every call, with valid arguments
    tests/api/exports.txt            symbols of the shared library

    runtime.py [--check]             --check writes nothing, and fails if a file is out of date
"""
import re
import sys
import textwrap

import output
import plain

HEAD = "// Written by bindings/generator/runtime.py from the public header.\n"
# Not recorded: they do not change the world.
NOT_RECORDED = {"lr_world_destroy", "lr_world_record_start", "lr_world_record_stop"}
# Repeated by hand-written code, not by their types.
OWN = {"lr_world_set_simd_target"}


def rows(words):
    return textwrap.wrap(" ".join(words), 148, break_long_words=False, break_on_hyphens=False)


def structs(model):
    return HEAD + "\n".join(rows([f"LR_STRUCT({s['name']},\0{s['name'].upper()}_INIT)" for s in model["structs"] if s["init"]])).replace("\0", " ") + "\n"


def status_texts(model):
    return HEAD + "".join(f'{{{c["name"]}, "{" ".join(c["doc"].split())}"}},\n' for c in model["constants"] if c.get("enum") == "lr_status")


def recorded(model):
    for function in model["functions"]:
        first = function["parameters"][0]["type"] if function["parameters"] else {}
        if first.get("kind") == "pointer" and first["to"].get("name") == "lr_world" and not first["const"] and \
                function["name"] not in NOT_RECORDED:
            yield function


def is_whole(model, type_):
    """Whether a type is a pointer to a const struct without pointers of its own."""
    sized = {s["name"] for s in model["structs"] if s["init"]}
    return type_["kind"] == "pointer" and type_["const"] and type_["to"].get("name") in sized and not plain.has_pointers(model, type_["to"]["name"])


def by_types(model, function):
    """Whether lr_replay can read the arguments by their types: numbers, single structs, three floats; or one array with its count."""
    types = [p["type"] for p in function["parameters"][1:]]
    if function["name"] in OWN:
        return False
    if len(types) == 2 and types[0]["kind"] == "pointer" and function["parameters"][2]["name"] == "count":
        return types[0]["const"] and types[0]["to"]["kind"] == "handle" or is_whole(model, types[0])
    return all(t["kind"] in ("scalar", "handle") or is_whole(model, t) or
               t["kind"] == "pointer" and t["const"] and t["to"].get("name") == "f32" for t in types)


def replay_calls(model):
    return HEAD + "".join(f"{'LR_BY_TYPES' if by_types(model, f) else 'LR_OWN'}({f['name'].removeprefix('lr_')})\n" for f in recorded(model))


def argument(parameter, sized):
    """A valid argument, in terms of tests/api/test_calls.cpp."""
    name, type_ = parameter["name"], parameter["type"]
    kind = type_["kind"]
    if kind == "callback":
        return "nullptr"
    if kind == "handle":
        return f"s.{type_['name'].removeprefix('lr_')}"
    if kind == "scalar":
        return "0" if name == "stride" else {"f32": "1.0f", "i32": "0"}.get(type_["name"], "1")
    if name == "user":
        return "nullptr"
    to = type_["to"]
    if to["kind"] == "opaque":
        place = f"s.{to['name'].removeprefix('lr_')}"
    elif to["kind"] == "handle" and type_["const"]:
        place = f"&s.{to['name'].removeprefix('lr_')}"
    elif to["kind"] == "struct" and to["name"] in sized:
        place = f"s.of<{to['name']}>()"
    elif to["kind"] == "scalar":
        place = f"s.memory<{'const ' if type_['const'] else ''}{C[to['name']]}>()"
    else:
        place = f"s.out<{to['to']['name']}*>()" if to["kind"] == "pointer" else f"s.memory<{to['name']}>()"
    return f"may({place})" if parameter["nullable"] else f"must({place})"


C = {"void": "void", "char": "char", "f32": "float", "f64": "double", "i32": "int32_t", "u32": "uint32_t", "i64": "int64_t", "u64": "uint64_t"}


def test_calls(model):
    """All functions that return a status, except those that fill a struct."""
    lines, names, sized = [], {f["name"] for f in model["functions"]}, {s["name"] for s in model["structs"] if s["init"]}
    simple = {call["function"]["name"] for call in plain.calls(model) if not call["pointers"]}
    for f in model["functions"]:
        if f["result"].get("name") != "lr_status" or f["name"].endswith("_init"):
            continue
        arguments = ", ".join(argument(p, sized) for p in f["parameters"])
        add = re.sub("^lr_world_(update|get)_", "lr_world_add_", f["name"])
        if add in names - {f["name"]}:  # wind sources: the source must be of the function's kind
            arguments = arguments.replace("s.wind_source", f"s.wind_source_of({add})")
        lines.append(f"LR_{'PLAIN_' if f['name'] in simple else ''}CALL({f['name']}, {arguments})\n")
    return HEAD + "".join(lines)


def exports(model):
    return "".join(sorted(f"{f['name']}\n" for f in model["functions"]))


def main():
    return output.run(__doc__, lambda model: {"src/api/structs.inc": structs(model), "src/api/status_texts.inc": status_texts(model), "src/tools/lr_replay/calls.inc": replay_calls(model),
                                              "tests/api/calls.inc": test_calls(model), "tests/api/exports.txt": exports(model)})


if __name__ == "__main__":
    sys.exit(not main())
