# SPDX-License-Identifier: MIT
"""The leaf: its mesh, its asset, and the object that is drawn."""
import bpy
import langevin_rigid as lr
import numpy as np
from langevin_rigid.mesh import Mesh
from mathutils import Matrix, Vector

from .units import Problem, metres_per_unit


def mesh_arrays(mesh):
    """Vertex positions and triangles."""
    mesh.calc_loop_triangles()
    vertices = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", vertices)
    triangles = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", triangles)
    return vertices.reshape(-1, 3), triangles.reshape(-1, 3)


def leaf_mesh(leaf, metres):
    """A leaf's mesh in metres, in its own frame."""
    if max(abs(s - 1) for s in leaf.scale) > 1e-4:
        raise Problem(f'"{leaf.name}" is scaled: apply its scale (Ctrl A), because the bake needs the mesh at its true size')
    vertices, triangles = mesh_arrays(leaf.data)
    if not len(triangles):
        raise Problem(f'"{leaf.name}" has no faces')
    return vertices * metres, triangles


def to_mesh(mesh, metres):
    """A mesh for the exporters."""
    vertices, triangles = mesh_arrays(mesh)
    return Mesh.from_triangles(vertices * metres, triangles)


def bake_asset(leaf, path, scene, **options):
    """Bakes an asset from an object's mesh by lr_bake and returns the report."""
    vertices, triangles = leaf_mesh(leaf, metres_per_unit(scene))
    try:
        return lr.bake_triangles(vertices, triangles, path, name=leaf.name[:60], **options)
    except lr.BakeError as error:
        raise Problem(str(error)) from error


def prototype_of(leaf, asset, metres):
    """A hidden object: the leaf's mesh with its origin at the centre of mass."""
    mesh = leaf.data.copy()
    mesh.name = f"{leaf.name} about its centre of mass"
    mesh.transform(Matrix.Translation(-Vector(asset.info.center_of_mass) / metres))
    return bpy.data.objects.new(mesh.name, mesh)


def object_of(mesh, name):
    """An object from an OBJ mesh, with its texture coordinates."""
    data = bpy.data.meshes.new(name)
    faces = np.split(mesh.indices, np.cumsum(mesh.counts)[:-1])
    data.from_pydata(mesh.points.tolist(), [], [face.tolist() for face in faces])
    if mesh.uvs is not None:
        data.uv_layers.new(name="UVMap").data.foreach_set("uv", mesh.uvs.astype(np.float32).ravel())
    data.polygons.foreach_set("use_smooth", [True] * len(data.polygons))
    data.update()
    return bpy.data.objects.new(name, data)

