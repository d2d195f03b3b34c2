# SPDX-License-Identifier: MIT
"""A recording as one object: a carrier with a point cache and geometry nodes."""
import bpy
import numpy as np
from langevin_rigid.export import write_carrier_pc2

from .nodes import GROUP, input_identifier, instance_group


def build_points(recording, prototype, collection, cache_path):
    """An object that carries all bodies: a point cache moves it, geometry nodes draw the leaves."""
    cache = write_carrier_pc2(bpy.path.abspath(cache_path), recording)
    mesh = bpy.data.meshes.new("Leaf Storm")
    mesh.vertices.add(cache.vertices)
    mesh.vertices.foreach_set("co", cache.first.astype(np.float32).ravel())
    mesh.update()
    carrier = bpy.data.objects.new("Leaf Storm", mesh)
    collection.objects.link(carrier)
    moves = carrier.modifiers.new("Point cache", "MESH_CACHE")
    moves.cache_format, moves.filepath = "PC2", cache_path
    moves.time_mode, moves.play_mode, moves.interpolation = "FRAME", "SCENE", "LINEAR"
    moves.frame_start = recording.first_frame
    draws = carrier.modifiers.new("Leaves", "NODES")
    draws.node_group = bpy.data.node_groups.get(GROUP) or instance_group()
    draws[input_identifier(draws.node_group, "Leaf")] = prototype
    return carrier
