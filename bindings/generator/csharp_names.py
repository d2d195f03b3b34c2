# SPDX-License-Identifier: MIT
"""C# names of types and fields, and the enum of each constant."""
import re

# Enums whose values are macros in the header; an enum with a typedef names itself. (enum, base, flags, constants, text): the first
# group is the member's name. The first pattern that matches takes a constant.
ENUMS = [
    ("Status", "int", False, r"LR_(?:ERROR_)?(OK|(?<=LR_ERROR_).+)", "Result of a call: Ok, or a negative error. Values are stable."),
    ("LogLevel", "int", False, r"LR_LOG_(.+)", "Severity of a log message."),
    ("SimdTarget", "int", False, r"LR_SIMD_(.+)", ""),
    ("AssetFlags", "uint", True, r"LR_ASSET_(.+)", "Properties of an asset."),
    ("VortexCore", "int", False, r"LR_VORTEX_(.+)", "The core of a vortex."),
    ("WindOutside", "int", False, r"LR_WIND_OUTSIDE_(.+)", "The value of a wind grid outside its samples."),
    ("LoadModel", "int", False, r"LR_LOADS_(.+)", "How the fluid's forces on bodies are computed."),
    ("TurbulenceClock", "int", False, r"LR_CLOCK_(.+)", "The clock of a body's turbulence."),
    ("TableEnd", "int", False, r"LR_TABLE_(.+)", "Continuation of a turbulence table after its last sample."),
    ("Integrator", "int", False, r"LR_INTEGRATOR_(.+)", "How motion is integrated."),
    ("TransformFormat", "int", False, r"LR_TRANSFORM_(.+)", "Memory layouts of transforms, in floats."),
    ("SleepState", "int", False, r"LR_SLEEP_(.+)", "A body's sleep state."),
    ("ForceMode", "int", False, r"LR_FORCE_MODE_(.+)", ""),
    ("ForceFlags", "uint", True, r"LR_FORCE_(AT_POINT)", "Options of a force on one body."),
    ("ForceFrame", "int", False, r"LR_FRAME_(.+)", "The frame of a force."),
    ("ColliderKind", "int", False, r"LR_COLLIDER_(.+)", ""),
    ("MoveMode", "int", False, r"LR_MOVE_(.+)", "Ways to move a collider."),
    ("ContactFlags", "uint", True, r"LR_CONTACT_(NEVER_SLEEP)", "Options of a batch's contact."),
    ("EventKind", "int", False, r"LR_EVENT_(.+)", "Kinds of events."),
    ("EventKinds", "uint", True, r"LR_EVENTS_(.+)", ""),
    ("RayFlags", "uint", True, r"LR_RAY_(.+)", "Targets of a ray."),
    ("OverlapShape", "int", False, r"LR_OVERLAP_(.+)", "Shapes of overlap queries."),
    ("EndAction", "int", False, r"LR_END_(.+)", "The fate of a body that its batch's rules end."),
    ("DivergencePolicy", "int", False, r"LR_DIVERGENCE_(.+)", "The fate of a diverged body."),
    ("VolumeShape", "int", False, r"LR_VOLUME_(.+)", "Shapes of kill volumes."),
    ("KillSide", "int", False, r"LR_KILL_(.+)", "The side of a kill volume on which bodies end."),
    ("EmitterShape", "int", False, r"LR_EMIT_(.+)", "Shapes in which an emitter spawns bodies."),
    ("EmitterPose", "int", False, r"LR_POSE_(.+)", "Orientations of spawned bodies."),
    ("WorldChecks", "uint", True, r"LR_CHECK_(.+)", "Run-time checks for misuse."),
    ("RecordingFlags", "uint", True, r"LR_RECORD_(.+)", "Options of a recording."),
]
LIMITS = r"LR_(MAX_.+)"

# For comments in which LR_X_* stands for another enum than its first constants would say, or for no LR_X_* at all.
FIELD_ENUMS = {
    ("lr_world_info", "simd_target"): "SimdTarget",
    ("lr_batch_contact", "flags"): "ContactFlags",
    ("lr_body_force", "flags"): "ForceFlags",
    ("lr_event", "kind"): "EventKind",
    ("lr_event_list", "kinds"): "EventKinds",
}
PARAMETER_ENUMS = {
    ("lr_simd_targets", "targets"): "SimdTarget",
    ("lr_simd_target_name", "target"): "SimdTarget",
    ("lr_world_set_simd_target", "target"): "SimdTarget",
    ("lr_batch_write_transforms", "format"): "TransformFormat",
    ("lr_body_set_sleep", "sleep_state"): "SleepState",
    ("lr_batch_set_divergence_policy", "policy"): "DivergencePolicy",
    ("lr_batch_get_divergence_policy", "policy"): "DivergencePolicy",
    ("lr_world_set_events", "kinds"): "EventKinds",
    ("lr_log_fn", "level"): "LogLevel",
}

# Unity has its own Event and Material.
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
        typed = [(type_name(e["name"]), SCALARS[e["of"]], e["of"] == "u32", None, e["doc"]) for e in model["enums"]]
        taken = {entry[0] for entry in typed}
        self.enums = typed + [entry for entry in ENUMS if entry[0] not in taken]
        self.enum_of, self.members, self.limits = {}, {e[0]: [] for e in self.enums}, []
        for constant in model["constants"]:
            self.place(constant)
        self.enums = [entry for entry in self.enums if self.members[entry[0]]]

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
        for enum, *_, pattern, _ in ENUMS:
            if match := re.fullmatch(pattern, name):
                member = pascal(match.group(1))
                self.members[enum].append((member, constant))
                self.enum_of[name] = (enum, member)
                return
        raise ValueError(f"{name}: no rule says which enum it belongs to: bindings/generator/csharp_names.py, ENUMS")

    def family(self, prefix):
        """The enum of the constants with this prefix."""
        return next((enum for name, (enum, _) in self.enum_of.items() if name.startswith(prefix + "_")), None)

    def field_enum(self, struct, field):
        if "enum" in field["type"]:
            return type_name(field["type"]["enum"])
        key = (struct["name"], field["name"])
        if key in FIELD_ENUMS:
            return FIELD_ENUMS[key]
        if field["type"].get("name") not in ("i32", "u32"):
            return None
        match = re.match(r"(?:bits )?(LR_[A-Z_]+?)_\*", field["doc"])
        if match:
            return self.family(match.group(1))
        if field["type"]["name"] == "i32":
            raise ValueError(f"{key}: an int32_t without an enum: bindings/generator/csharp_names.py, FIELD_ENUMS")
        return None

    def parameter_enum(self, function, parameter):
        type_ = parameter["type"]
        scalar = type_["to"] if type_["kind"] == "pointer" else type_
        if "enum" in scalar:
            return type_name(scalar["enum"])
        key = (function, parameter["name"])
        if key in PARAMETER_ENUMS:
            return PARAMETER_ENUMS[key]
        if scalar.get("name") == "i32" and parameter["name"] not in ("enabled", "present"):
            raise ValueError(f"{key}: an int32_t without an enum: bindings/generator/csharp_names.py, PARAMETER_ENUMS")
        return None
