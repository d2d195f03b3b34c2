# SPDX-License-Identifier: MIT
"""What things of the header are called in C#: types, fields, and which enum each constant belongs to."""
import re

# (enum, base, flags, constants, what it is); the member's name is the first group. The first that matches takes a constant.
ENUMS = [
    ("Status", "int", False, r"LR_(?:ERROR_)?(OK|(?<=LR_ERROR_).+)", "What a call returns: Ok, or a negative error. Values are stable."),
    ("LogLevel", "int", False, r"LR_LOG_(.+)", "How much a message of the library matters."),
    ("SimdTarget", "int", False, r"LR_SIMD_(.+)", ""),
    ("AssetFlags", "uint", True, r"LR_ASSET_(.+)", "What holds of an asset."),
    ("WindSourceKind", "int", False, r"LR_WIND_SOURCE_(.+)", ""),
    ("WindOutside", "int", False, r"LR_WIND_OUTSIDE_(.+)", "What a grid of wind is outside its samples."),
    ("WindKind", "int", False, r"LR_WIND_(.+)", "Kinds of the uniform part of the wind."),
    ("LoadModel", "int", False, r"LR_LOADS_(.+)", "How the fluid's forces on bodies are computed."),
    ("TurbulenceClock", "int", False, r"LR_CLOCK_(.+)", "What the turbulence of a body follows."),
    ("TableEnd", "int", False, r"LR_TABLE_(.+)", "What follows the last sample of a turbulence table."),
    ("Integrator", "int", False, r"LR_INTEGRATOR_(.+)", "How motion is integrated."),
    ("TransformFormat", "int", False, r"LR_TRANSFORM_(.+)", "Layouts of transforms, as float elements."),
    ("RestState", "int", False, r"LR_REST_(.+)", "Whether a body is at rest."),
    ("ForceMode", "int", False, r"LR_FORCE_MODE_(.+)", ""),
    ("ForceFlags", "uint", True, r"LR_FORCE_(AT_POINT)", "Of a force on one body."),
    ("ForceFrame", "int", False, r"LR_FRAME_(.+)", "The frame that a force is given in."),
    ("ColliderKind", "int", False, r"LR_COLLIDER_(.+)", ""),
    ("MoveMode", "int", False, r"LR_MOVE_(.+)", "How a collider is moved."),
    ("ContactFlags", "uint", True, r"LR_CONTACT_(NEVER_REST)", "Of the contact of a batch."),
    ("ContactEventKind", "int", False, r"LR_(CONTACT_(?:BEGIN|END)|BODY_.+)", "What happened to a body."),
    ("ContactEvents", "uint", True, r"LR_EVENTS_(.+)", ""),
    ("RayFlags", "uint", True, r"LR_RAY_(.+)", "What a ray can hit."),
    ("OverlapShape", "int", False, r"LR_OVERLAP_(.+)", "Shapes of overlap queries."),
    ("EndAction", "int", False, r"LR_END_(.+)", "What becomes of a body that its batch's rules end."),
    ("FaultPolicy", "int", False, r"LR_FAULT_(.+)", "What becomes of a body that has left physics."),
    ("VolumeShape", "int", False, r"LR_VOLUME_(.+)", "Shapes of kill volumes."),
    ("KillSide", "int", False, r"LR_KILL_(.+)", "On which side of a kill volume bodies end."),
    ("EmitterShape", "int", False, r"LR_EMIT_(.+)", "Where an emitter bears bodies."),
    ("EmitterPose", "int", False, r"LR_POSE_(.+)", "How bodies are turned at birth."),
    ("WorldChecks", "uint", True, r"LR_CHECK_(.+)", "Misuse that is found at run time."),
    ("RecordingFlags", "uint", True, r"LR_RECORD_(.+)", "Of a recording."),
]
LIMITS = r"LR_(MAX_.+)"

# Where a comment's LR_X_* stands for another enum than its first constants would say, or says nothing.
FIELD_ENUMS = {
    ("lr_world_info", "simd_target"): "SimdTarget",
    ("lr_batch_contact", "flags"): "ContactFlags",
    ("lr_body_force", "flags"): "ForceFlags",
    ("lr_contact_event", "kind"): "ContactEventKind",
}
PARAMETER_ENUMS = {
    ("lr_simd_targets", "targets"): "SimdTarget",
    ("lr_simd_target_name", "target"): "SimdTarget",
    ("lr_world_set_simd_target", "target"): "SimdTarget",
    ("lr_batch_write_transforms", "format"): "TransformFormat",
    ("lr_body_set_rest", "rest"): "RestState",
    ("lr_batch_set_fault_policy", "policy"): "FaultPolicy",
    ("lr_batch_get_fault_policy", "policy"): "FaultPolicy",
    ("lr_world_set_contact_events", "kinds"): "ContactEvents",
    ("lr_log_fn", "level"): "LogLevel",
}
# int32_t parameters that are numbers.
PLAIN_PARAMETERS = {("lr_batch_set_pair_contact", "enabled"), ("lr_batch_get_pair_contact", "enabled")}

HANDLES = {"lr_status": "Status", "lr_batch": "BatchId", "lr_body": "BodyId", "lr_wind_source": "WindSourceId",
           "lr_collider": "ColliderId"}
WORDS = {"SIMD": "Simd", "RK4": "Rk4", "3X4": "Matrix3x4", "4X4": "Matrix4x4"}
SCALARS = {"void": "void", "char": "byte", "i8": "sbyte", "u8": "byte", "i16": "short", "u16": "ushort", "i32": "int", "u32": "uint",
           "i64": "long", "u64": "ulong", "f32": "float", "f64": "double"}
VECTORS = {("f32", 2): "Float2", ("f32", 3): "Float3", ("f32", 4): "Float4", ("f64", 3): "Double3", ("u32", 2): "UInt2",
           ("u32", 3): "UInt3"}
# Arrays that C# has no fixed buffers of become a field for each element.
SUFFIXES = {3: "XYZ", 4: "XYZW"}
KEYWORDS = {"in", "out", "ref", "params", "base", "event", "object", "string", "fixed", "checked", "lock", "operator", "is", "as"}


def pascal(name):
    return "".join(WORDS.get(word, word[:1].upper() + word[1:].lower()) for word in name.split("_") if word)


def camel(name):
    name = pascal(name)
    name = name[0].lower() + name[1:]
    return "@" + name if name in KEYWORDS else name


def type_name(name):
    """Of a struct, handle or callback."""
    return HANDLES.get(name) or pascal(name.removeprefix("lr_"))


def suffixes(count):
    return list(SUFFIXES[count]) if count in SUFFIXES else [str(i) for i in range(count)]


class Names:
    """Of one model: every constant must find its place."""

    def __init__(self, model):
        self.model = model
        self.structs = {s["name"]: s for s in model["structs"]}
        self.functions = {f["name"]: f for f in model["functions"]}
        self.callbacks = {c["name"]: c for c in model["callbacks"]}
        self.enum_of, self.members, self.limits = {}, {e[0]: [] for e in ENUMS}, []
        for constant in model["constants"]:
            self.place(constant)
        empty = [name for name, members in self.members.items() if not members]
        if empty:
            raise ValueError(f"enums without a constant: {empty}")

    def place(self, constant):
        name = constant["name"]
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
        """The enum of the constants that begin like this."""
        return next((enum for name, (enum, _) in self.enum_of.items() if name.startswith(prefix + "_")), None)

    def field_enum(self, struct, field):
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
        key = (function, parameter["name"])
        if key in PARAMETER_ENUMS:
            return PARAMETER_ENUMS[key]
        type_ = parameter["type"]
        scalar = type_["to"] if type_["kind"] == "pointer" else type_
        if scalar.get("name") == "i32" and key not in PLAIN_PARAMETERS:
            raise ValueError(f"{key}: an int32_t without an enum: bindings/generator/csharp_names.py, PARAMETER_ENUMS")
        return None
