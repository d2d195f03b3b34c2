# SPDX-License-Identifier: MIT
"""What things of the header are called in C#: types, fields and constants."""
import re

LIMITS = r"LR_(MAX_.+)"

# UnityEngine has an Event and a Material.
STRUCTS = {"lr_event": "BodyEvent", "lr_material": "ColliderMaterial"}
HANDLES = {"lr_status": "Status"}  # others come from the model
WORDS = {"SIMD": "Simd", "RK4": "Rk4", "3X4": "Matrix3x4", "4X4": "Matrix4x4"}
SCALARS = {"void": "void", "char": "byte", "i8": "sbyte", "u8": "byte", "i16": "short", "u16": "ushort", "i32": "int", "u32": "uint",
           "i64": "long", "u64": "ulong", "f32": "float", "f64": "double"}
VECTORS = {("f32", 2): "Float2", ("f32", 3): "Float3", ("f32", 4): "Float4", ("f64", 3): "Double3", ("u32", 2): "UInt2",
           ("u32", 3): "UInt3"}
# C# has no fixed buffers of these elements, so each element becomes a field.
SUFFIXES = {3: "XYZ", 4: "XYZW"}
KEYWORDS = {"in", "out", "ref", "params", "base", "event", "object", "string", "fixed", "checked", "lock", "operator", "is", "as"}


def pascal(name):
    return "".join(WORDS.get(word, word[:1].upper() + word[1:].lower()) for word in name.split("_") if word)


def camel(name):
    name = pascal(name)
    name = name[0].lower() + name[1:]
    return "@" + name if name in KEYWORDS else name


def type_name(name):
    """The C# name of a struct, handle or callback."""
    return HANDLES.get(name) or STRUCTS.get(name) or pascal(name.removeprefix("lr_"))


def suffixes(count):
    return list(SUFFIXES[count]) if count in SUFFIXES else [str(i) for i in range(count)]


class Names:
    """Names for a model: every constant must belong to an enum."""

    def __init__(self, model):
        self.model = model
        HANDLES.update({h["name"]: pascal(h["name"].removeprefix("lr_")) + "Id" for h in model["handles"] if h["name"] != "lr_status"})
        self.structs = {s["name"]: s for s in model["structs"]}
        self.functions = {f["name"]: f for f in model["functions"]}
        self.callbacks = {c["name"]: c for c in model["callbacks"]}
        self.typed = {e["name"]: e for e in model["enums"]}
        self.enums = [(type_name(e["name"]), SCALARS[e["of"]], e["of"] == "u32", e["doc"]) for e in model["enums"]]
        self.prefixes = {e["prefix"]: type_name(e["name"]) for e in model["enums"]}
        self.enum_of, self.members, self.limits = {}, {e[0]: [] for e in self.enums}, []
        for constant in model["constants"]:
            self.place(constant)

    def place(self, constant):
        name = constant["name"]
        if "enum" in constant:
            enum, member = constant["enum"], name.removeprefix(self.typed[constant["enum"]]["prefix"])
            member = pascal(member.removeprefix("ERROR_") if enum == "lr_status" else member)
            self.members[type_name(enum)].append((member, constant))
            self.enum_of[name] = (type_name(enum), member)
            return
        if match := re.fullmatch(LIMITS, name):
            self.limits.append((pascal(match.group(1)), constant))
            self.enum_of[name] = ("Limits", pascal(match.group(1)))
            return
        raise ValueError(f"{name}: neither a limit nor in an enum")

    def enum(self, type_):
        """The enum of a field's or parameter's values; None for plain numbers."""
        scalar = type_["to"] if type_["kind"] == "pointer" else type_
        return type_name(scalar["enum"]) if "enum" in scalar else None
