# SPDX-License-Identifier: MIT
"""The scene's colliders: mesh objects with Collision physics, and those of a collection."""
import bpy
import langevin_rigid as lr
import numpy as np
from mathutils import Vector

from .leaf import mesh_arrays


def of_scene(scene, collection=None, without=()):
    """Mesh objects that leaves collide with."""
    chosen = list(collection.all_objects) if collection is not None else []
    chosen += [thing for thing in scene.objects if thing.collision is not None and thing.collision.use and thing not in chosen]
    return [thing for thing in chosen if thing.type == "MESH" and thing not in without]


class Surface:
    """A mesh object in metres. Its vertices are in a frame that turns and moves with the object, but has no scale or shear."""

    def __init__(self, thing, metres):
        self.thing, self.metres = thing, metres
        evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
        mesh = evaluated.to_mesh()
        vertices, self.triangles = mesh_arrays(mesh)
        self.is_polygon = len(mesh.polygons) == 1
        evaluated.to_mesh_clear()
        whole, turn = np.array(thing.matrix_world)[:3, :3], np.array(thing.matrix_world.decompose()[1].to_matrix())
        self.vertices = vertices @ (turn.T @ whole).T * metres
        self.world = self.vertices @ turn.T + np.array(thing.matrix_world.translation) * metres

    def pose(self, point=(0, 0, 0), turn=None):
        """Where the object has a point of it, m, and a frame in it, now."""
        location, own, _ = self.thing.matrix_world.decompose()
        whole = own if turn is None else own @ turn
        return np.array(location) * self.metres + np.array(own.to_matrix()) @ point, (whole.x, whole.y, whole.z, whole.w)

    def frame_of(self, normal):
        """A frame at the surface's middle with y along a normal, which is in world space: as arguments of `pose`."""
        own = np.array(self.thing.matrix_world.decompose()[1].to_matrix()).T @ normal
        return self.vertices.mean(0), Vector((0, 1, 0)).rotation_difference(Vector(own))

    def upward(self, gravity):
        """The normal of a flat polygon that faces up, in world space, or None."""
        if not self.is_polygon or not len(self.triangles) or not np.any(gravity):
            return None
        a, b, c = (self.world[self.triangles[:, i]] for i in range(3))
        normal = np.cross(b - a, c - a).sum(0)
        size = np.linalg.norm(normal)
        if size == 0:
            return None
        normal /= size
        offsets = (self.world - self.world.mean(0)) @ normal
        up = -(normal @ gravity) / np.linalg.norm(gravity)
        if np.ptp(offsets) > 1e-4 * np.sqrt(size) or abs(up) < 0.7:
            return None
        return normal if up > 0 else -normal


def grounds(surfaces, gravity, spawn):
    """The normals of planes that are the ground, and None for all other surfaces.

    The ground is a single flat polygon that faces up, with all leaves above and no other collider wholly below it. It goes on
    beyond its edges, so that leaves that are blown off it do not fall for ever. A plane as a table top keeps its edges.
    """
    found = []
    for surface in surfaces:
        normal = surface.upward(gravity)
        if normal is not None:
            point, reach = surface.world.mean(0), np.ptp(surface.world, axis=0).max()
            below = any(((other.world - point) @ normal).max() < -1e-4 * reach for other in surfaces if other is not surface)
            if below or (spawn - point) @ normal <= 0:
                normal = None
        found.append(normal)
    return found


class Colliders:
    """The colliders of a world, which follow their objects' motion but not deformation of their meshes."""

    def __init__(self, world, things, metres, gravity, spawn, friction):
        """spawn: the centre of the box in which leaves spawn, m."""
        self.followed = []
        surfaces = [Surface(thing, metres) for thing in things]
        surfaces = [surface for surface in surfaces if len(surface.triangles)]
        for surface, normal in zip(surfaces, grounds(surfaces, gravity, np.asarray(spawn))):
            shape, frame = {"kind": lr.ColliderKind.MESH, "vertices": surface.vertices, "indices": surface.triangles}, ()
            if normal is not None:
                shape, frame = {"kind": lr.ColliderKind.PLANE}, surface.frame_of(normal)
            position, orientation = surface.pose(*frame)
            collider = world.add_collider(**shape, position=position, orientation=orientation, friction=friction)
            self.followed.append((surface, frame, collider))

    def follow(self):
        for surface, frame, collider in self.followed:
            collider.move_to(*surface.pose(*frame))
