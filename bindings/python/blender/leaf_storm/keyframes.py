# SPDX-License-Identifier: MIT
"""A recording as objects with keyframes, one for each body."""
import bpy
import numpy as np


def build_keyframes(recording, prototype, collection):
    """Objects that share the prototype's mesh. Before its body's first frame and after the last, an object has scale 0."""
    slots, count = recording.slots()
    numbers = np.array(recording.frame_numbers, np.float32)
    values = {"location": np.zeros((len(recording), count, 3), np.float32),
              "rotation_quaternion": np.zeros((len(recording), count, 4), np.float32),
              "scale": np.zeros((len(recording), count, 3), np.float32)}
    values["rotation_quaternion"][..., 0] = 1
    known = np.full(count, -1)
    for at, (frame, slot) in enumerate(zip(recording, slots)):
        quaternion = frame.orientation[:, [3, 0, 1, 2]]
        if at:  # a quaternion and its negative are the same rotation: take the one near the last, or the leaf turns the long way round
            values["location"][at], values["rotation_quaternion"][at] = values["location"][at - 1], values["rotation_quaternion"][at - 1]
            last = values["rotation_quaternion"][at - 1, slot]
            quaternion = np.where((quaternion * last).sum(1, keepdims=True) < 0, -quaternion, quaternion)
        values["location"][at, slot], values["rotation_quaternion"][at, slot] = frame.position, quaternion
        values["scale"][at, slot] = frame.scale[:, None]
        before = slot[known[slot] < at - 1]
        if at:  # spawned in this frame: it already waits here in the frame before
            values["location"][at - 1, before] = values["location"][at, before]
            values["rotation_quaternion"][at - 1, before] = values["rotation_quaternion"][at, before]
        known[slot] = at
    made = []
    for body in range(count):
        thing = bpy.data.objects.new(f"Leaf {body:04}", prototype.data)
        thing.rotation_mode = "QUATERNION"
        collection.objects.link(thing)
        action = bpy.data.actions.new(thing.name)
        thing.animation_data_create().action = action
        for path, numbers_of in values.items():
            for axis in range(numbers_of.shape[2]):
                curve = new_curve(action, thing, path, axis)
                curve.keyframe_points.add(len(numbers))
                curve.keyframe_points.foreach_set("co", np.stack([numbers, numbers_of[:, body, axis]], axis=-1).ravel())
                for point in curve.keyframe_points:
                    point.interpolation = "LINEAR"
                curve.update()
        made.append(thing)
    return made


def new_curve(action, thing, path, axis):
    if hasattr(action, "fcurves"):
        return action.fcurves.new(path, index=axis, action_group="Leaf")
    return action.fcurve_ensure_for_datablock(thing, path, index=axis, group_name="Leaf")  # Blender 5.0
