# SPDX-License-Identifier: MIT
"""Falling leaves in Blender: an add-on (sidebar of the 3D view, "Leaves") and a command.

A baked storm plays without Python: as one carrier mesh with a point cache (PC2), on which geometry nodes instance the leaves, or,
for a few leaves, as an object with keyframes for each. Gravity is the scene's, along -z by default; Blender's axes are the
library's.

    blender -b [scene.blend] -P leaf_storm.py -- --mesh leaf.obj [--asset leaf.lrb] [--count 300] [--frames 96]
        [--mode points|keyframes] [--save out.blend] [--render picture.png --at 60]
"""
import argparse
import math
import os
import pathlib
import sys

import bpy
import numpy as np
from mathutils import Matrix, Vector

# The package lies beside this file, or in LANGEVIN_RIGID_PYTHON, unless Blender's Python has it.
for _folder in (os.environ.get("LANGEVIN_RIGID_PYTHON"), str(pathlib.Path(__file__).resolve().parents[1])):
    if _folder and os.path.isdir(os.path.join(_folder, "langevin_rigid")) and _folder not in sys.path:
        sys.path.append(_folder)

try:
    import langevin_rigid as lr
except ModuleNotFoundError as error:
    raise ImportError(f"Leaf Storm needs {error.name} in Blender's Python: unpack the wheel of langevin_rigid in "
                      f"{bpy.utils.user_resource('SCRIPTS', path='addons/modules')}, or set LANGEVIN_RIGID_PYTHON to its folder") from error
from langevin_rigid.export import write_carrier_pc2, write_usda  # noqa: E402
from langevin_rigid.mesh import Mesh  # noqa: E402

bl_info = {
    "name": "Leaf Storm (Langevin Rigid)",
    "author": "Langevin Rigid",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D view > Sidebar > Leaves",
    "description": "Bakes falling leaves, paper and petals to instances",
    "category": "Physics",
}

GROUP = "Leaf Storm Instances"


class Problem(Exception):
    """A mistake of the user, reported by operators."""


# Units: metres in the library, the scene's unit in Blender.

def metres_per_unit(scene):
    settings = scene.unit_settings
    return settings.scale_length if settings.system != "NONE" else 1.0


def in_units(recording, metres):
    """A copy with lengths in Blender's units."""
    scaled = lr.Recording(recording.fps, recording.first_frame)
    scaled.frames = [frame._replace(position=frame.position / np.float32(metres), velocity=frame.velocity / np.float32(metres))
                     for frame in recording]
    return scaled


# Meshes.

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


# The scene as input of the world.

class Obstacle:
    """A mesh object as a collider. It follows the object's motion, but not deformation of the mesh."""

    def __init__(self, world, thing, metres):
        self.thing, self.metres = thing, metres
        evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
        mesh = evaluated.to_mesh()
        vertices, triangles = mesh_arrays(mesh)
        evaluated.to_mesh_clear()
        position, orientation, scale = self.pose()
        self.collider = world.add_mesh(vertices * np.array(scale) * metres, triangles, position=position,
                                       orientation=orientation, friction=0.6)

    def pose(self):
        location, turn, scale = self.thing.matrix_world.decompose()
        return np.array(location) * self.metres, (turn.x, turn.y, turn.z, turn.w), scale

    def follow(self):
        position, orientation, _ = self.pose()
        self.collider.move_to(position, orientation)


def wind_of(scene):
    """The sum of the scene's wind force fields; strength counts as m/s along the field's z axis."""
    total = Vector((0.0, 0.0, 0.0))
    for thing in scene.objects:
        if thing.field is not None and thing.field.type == "WIND" and not thing.hide_render:
            total += thing.matrix_world.to_3x3().normalized() @ Vector((0, 0, thing.field.strength))
    return total


def simulate(scene, asset, settings, progress=lambda part: None):
    """Simulates the frames of a scene and returns a recording in metres."""
    metres = metres_per_unit(scene)
    fps = scene.render.fps / scene.render.fps_base
    first, last = scene.frame_start, scene.frame_end
    if last <= first:
        raise Problem("the scene has no frames")
    recording = lr.Recording(fps=fps, first_frame=first)
    was_at = scene.frame_current
    gravity = np.array(scene.gravity) * metres if scene.use_gravity else np.zeros(3)
    try:
        with lr.World(seed=settings.seed, gravity=gravity, worker_count=min((os.cpu_count() or 1) - 1, 64)) as world:
            scene.frame_set(first)
            if settings.ground:
                world.add_plane((0, 0, settings.ground_height * metres), (0, 0, 1), friction=0.7)
            obstacles = [Obstacle(world, thing, metres) for thing in settings.obstacles]
            blowing = Vector(settings.wind) + wind_of(scene)
            world.set_uniform_wind(blowing)
            if settings.gusts > 0:
                along = blowing if blowing.length > 0 else Vector((1, 0, 0))
                world.add_gusts(direction=along, rms=settings.gusts, integral_time=2, angle_rms=0.3)
            if settings.turbulence > 0:
                world.add_turbulence(rms=settings.turbulence, integral_length=1)
            batch = world.create_batch(asset, capacity=settings.count)
            batch.set_emitter(shape=lr.EmitterShape.BOX, position=np.array(settings.center) * metres,
                              size=np.array(settings.size) * metres / 2, rate=settings.rate,
                              scale_min=1 - settings.variation, scale_max=1 + settings.variation)
            if settings.lifetime > 0:
                batch.set_rules(max_age=settings.lifetime)
            if settings.heaps:
                batch.set_body_contact(batch)
            if settings.rate == 0:
                batch.emit(settings.count)
            substeps = max(1, math.ceil(120 / fps))
            for frame in range(first, last + 1):
                recording.capture(batch)
                if frame < last:
                    scene.frame_set(frame + 1)
                    for obstacle in obstacles:
                        obstacle.follow()
                    world.step(1 / fps, substeps)
                progress((frame - first + 1) / (last - first + 1))
    finally:
        scene.frame_set(was_at)
    return recording


# From a recording to Blender: a carrier with a point cache and geometry nodes.

def socket(sockets, name):
    """The enabled socket of a name: nodes have a socket for each type of data."""
    found = [s for s in sockets if s.name == name and s.enabled]
    if not found:
        raise Problem(f"nodes of this Blender version have no socket {name!r}")
    return found[0]


def align_node(nodes, axis, pivot):
    new = "FunctionNodeAlignRotationToVector"  # Blender 4.2
    node = nodes.new(new if hasattr(bpy.types, new) else "FunctionNodeAlignEulerToVector")
    node.axis, node.pivot_axis = axis, pivot
    return node


def instance_group():
    """Builds nodes that instance the prototype on every third vertex, oriented and scaled by the two vertices after it."""
    group = bpy.data.node_groups.new(GROUP, "GeometryNodeTree")
    if hasattr(group, "interface"):  # Blender 4.0
        group.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        group.interface.new_socket("Leaf", in_out="INPUT", socket_type="NodeSocketObject")
        group.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        group.inputs.new("NodeSocketGeometry", "Geometry")
        group.inputs.new("NodeSocketObject", "Leaf")
        group.outputs.new("NodeSocketGeometry", "Geometry")
    nodes, link = group.nodes, group.links.new

    def add(kind, x, y, **properties):
        node = nodes.new(kind)
        node.location = (x, y)
        for name, value in properties.items():
            setattr(node, name, value)
        return node

    start, end = add("NodeGroupInput", -1200, 200), add("NodeGroupOutput", 600, 200)
    index, position = add("GeometryNodeInputIndex", -1200, -100), add("GeometryNodeInputPosition", -1200, -200)
    third = add("ShaderNodeMath", -900, 50, operation="MODULO")
    link(index.outputs[0], third.inputs[0])
    third.inputs[1].default_value = 3
    is_center = add("ShaderNodeMath", -700, 50, operation="LESS_THAN")
    link(third.outputs[0], is_center.inputs[0])
    is_center.inputs[1].default_value = 0.5
    arms = []
    for step in (1, 2):
        y = -150 - 200 * step
        after = add("ShaderNodeMath", -1000, y, operation="ADD")
        link(index.outputs[0], after.inputs[0])
        after.inputs[1].default_value = step
        at = add("GeometryNodeFieldAtIndex", -800, y, data_type="FLOAT_VECTOR", domain="POINT")
        link(after.outputs[0], at.inputs["Index"])
        link(position.outputs[0], socket(at.inputs, "Value"))
        arm = add("ShaderNodeVectorMath", -600, y, operation="SUBTRACT")
        link(socket(at.outputs, "Value"), arm.inputs[0])
        link(position.outputs[0], arm.inputs[1])
        arms.append(arm)
    normal = add("ShaderNodeVectorMath", -400, -450, operation="CROSS_PRODUCT")
    link(arms[0].outputs[0], normal.inputs[0])
    link(arms[1].outputs[0], normal.inputs[1])
    scale = add("ShaderNodeVectorMath", -400, -250, operation="LENGTH")
    link(arms[0].outputs[0], scale.inputs[0])
    upright, turned = align_node(nodes, "Z", "AUTO"), align_node(nodes, "X", "Z")
    upright.location, turned.location = (-200, -450), (0, -350)
    link(normal.outputs[0], upright.inputs["Vector"])
    link(upright.outputs[0], turned.inputs["Rotation"])
    link(arms[0].outputs[0], turned.inputs["Vector"])
    info = add("GeometryNodeObjectInfo", 100, -50, transform_space="ORIGINAL")
    info.inputs["As Instance"].default_value = True
    link(start.outputs["Leaf"], info.inputs["Object"])
    place = add("GeometryNodeInstanceOnPoints", 350, 200)
    link(start.outputs["Geometry"], place.inputs["Points"])
    link(is_center.outputs[0], place.inputs["Selection"])
    link(info.outputs["Geometry"], place.inputs["Instance"])
    link(turned.outputs[0], place.inputs["Rotation"])
    link(socket(scale.outputs, "Value"), place.inputs["Scale"])
    link(place.outputs[0], end.inputs[0])
    return group


def input_identifier(group, name):
    items = [i for i in group.interface.items_tree if i.in_out == "INPUT"] if hasattr(group, "interface") else group.inputs
    return next(item.identifier for item in items if item.name == name)


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


# From a recording to Blender: an object with keyframes for each body.

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


def bake_storm(scene, leaf, asset, settings, mode, cache_path, progress=lambda part: None):
    """Simulates and builds objects; returns the recording in metres and the collection."""
    metres = metres_per_unit(scene)
    recording = simulate(scene, asset, settings, progress)
    if not any(len(frame.ids) for frame in recording):
        raise Problem("no leaf was spawned in these frames: raise the rate or the number of frames")
    name = "Leaf Storm"
    old = bpy.data.collections.get(name)
    if old is not None:
        for thing in list(old.objects):
            bpy.data.objects.remove(thing, do_unlink=True)
        bpy.data.collections.remove(old)
    collection = bpy.data.collections.new(name)
    scene.collection.children.link(collection)
    prototype = prototype_of(leaf, asset, metres)
    scaled = in_units(recording, metres)
    if mode == "KEYFRAMES":
        build_keyframes(scaled, prototype, collection)
        bpy.data.objects.remove(prototype)
    else:
        prototype.hide_render = prototype.hide_viewport = True
        collection.objects.link(prototype)
        build_points(scaled, prototype, collection, cache_path)
    return recording, collection


class Settings:
    """Settings of a storm: lengths in Blender's units, speeds in m/s."""

    def __init__(self, **values):
        self.count, self.rate, self.lifetime, self.variation, self.seed = 300, 0.0, 0.0, 0.2, 0
        self.center, self.size = (0.0, 0.0, 3.0), (4.0, 4.0, 1.0)
        self.wind, self.gusts, self.turbulence = (0.0, 0.0, 0.0), 0.0, 0.3
        self.ground, self.ground_height, self.heaps, self.obstacles = True, 0.0, False, []
        self.__dict__.update(values)


# The add-on.

class StormProperties(bpy.types.PropertyGroup):
    leaf: bpy.props.PointerProperty(name="Leaf", type=bpy.types.Object, poll=lambda self, thing: thing.type == "MESH",
                                    description="The mesh that falls, at its true size, with its scale applied")
    asset: bpy.props.StringProperty(name="Asset", subtype="FILE_PATH", default="//leaf.lrb", description="Asset file made by lr_bake")
    density: bpy.props.FloatProperty(name="Density", default=350, min=0.1, description="Density of the leaf, kg/m^3, used by the bake")
    sheet: bpy.props.BoolProperty(name="Open sheet", description="The mesh is the middle surface of a sheet, without thickness")
    thickness: bpy.props.FloatProperty(name="Thickness", default=0.3, min=0.001, description="Thickness of the sheet, mm")
    area: bpy.props.PointerProperty(name="Area", type=bpy.types.Object, description="Leaves spawn in this object's bounding box; "
                                    "without an object, in a box of 4 x 4 x 1 at a height of 3")
    obstacles: bpy.props.PointerProperty(name="Obstacles", type=bpy.types.Collection, description="Meshes that leaves land on")
    count: bpy.props.IntProperty(name="Leaves", default=1000, min=1, max=1000000)
    rate: bpy.props.FloatProperty(name="Leaves per second", default=0, min=0, description="Leaves spawned per second; 0 spawns all at the start")
    lifetime: bpy.props.FloatProperty(name="Lifetime", default=0, min=0, description="Seconds until a leaf disappears; 0: never")
    variation: bpy.props.FloatProperty(name="Variation", default=0.2, min=0, max=0.9, description="Relative variation of size between leaves")
    seed: bpy.props.IntProperty(name="Seed", default=0, min=0)
    wind: bpy.props.FloatVectorProperty(name="Wind", subtype="VELOCITY", description="Uniform wind, m/s; wind force fields of the scene are added")
    gusts: bpy.props.FloatProperty(name="Gusts", default=0.5, min=0, description="Root mean square of gusts, m/s")
    turbulence: bpy.props.FloatProperty(name="Turbulence", default=0.3, min=0, description="Root mean square of turbulence, m/s")
    ground: bpy.props.BoolProperty(name="Ground", default=True)
    ground_height: bpy.props.FloatProperty(name="Height", default=0)
    heaps: bpy.props.BoolProperty(name="Heaps", description="Leaves collide with each other and pile up")
    mode: bpy.props.EnumProperty(name="Output", items=[
        ("POINTS", "Instances", "One object with a point cache and geometry nodes: any number of leaves"),
        ("KEYFRAMES", "Keyframes", "An object for each leaf: up to a few hundred, for editing by hand")])
    cache: bpy.props.StringProperty(name="Cache", subtype="FILE_PATH", default="//leaf_storm.pc2")

    def settings(self):
        values = {name: getattr(self, name) for name in ("count", "rate", "lifetime", "variation", "seed", "gusts", "turbulence",
                                                         "ground", "ground_height", "heaps")}
        if self.area is not None:
            corners = np.array([self.area.matrix_world @ Vector(corner) for corner in self.area.bound_box])
            values.update(center=(corners.min(0) + corners.max(0)) / 2, size=np.ptp(corners, axis=0))
        things = self.obstacles.all_objects if self.obstacles is not None else []
        return Settings(wind=tuple(self.wind), obstacles=[thing for thing in things if thing.type == "MESH"], **values)


def checked_path(path, what):
    if path.startswith("//") and not bpy.data.filepath:
        raise Problem(f"{what}: save the file first, or give an absolute path")
    return bpy.path.abspath(path)


class StormOperator(bpy.types.Operator):
    """Reports problems instead of raising them."""

    def execute(self, context):
        storm = context.scene.leaf_storm
        try:
            if storm.leaf is None:
                raise Problem("choose the leaf: a mesh object")
            self.report({"INFO"}, self.work(context, storm))
        except (Problem, lr.Error, OSError) as problem:
            self.report({"ERROR"}, str(problem))
            return {"CANCELLED"}
        return {"FINISHED"}


class LEAFSTORM_OT_bake_asset(StormOperator):
    """Compute mass and added mass of the leaf's mesh"""
    bl_idname, bl_label = "leaf_storm.bake_asset", "Bake Asset"

    def work(self, context, storm):
        options = {"density": storm.density}
        if storm.sheet:
            options.update(sheet=True, thickness=storm.thickness * 1e-3)
        report = bake_asset(storm.leaf, checked_path(storm.asset, "Asset"), context.scene, **options)
        return f"{report['mass'] * 1e3:.3g} g"


class LEAFSTORM_OT_bake_storm(StormOperator):
    """Simulate falling leaves in the frames of the scene"""
    bl_idname, bl_label = "leaf_storm.bake_storm", "Bake Storm"
    bl_options = {"REGISTER", "UNDO"}

    def work(self, context, storm):
        asset = lr.Asset.load(checked_path(storm.asset, "Asset"))
        if storm.mode == "POINTS":
            checked_path(storm.cache, "Cache")
        context.window_manager.progress_begin(0, 1)
        try:
            recording, _ = bake_storm(context.scene, storm.leaf, asset, storm.settings(), storm.mode, storm.cache,
                                      context.window_manager.progress_update)
        finally:
            context.window_manager.progress_end()
        return f"{max(len(frame.ids) for frame in recording)} leaves, {len(recording)} frames"


class LEAFSTORM_OT_export_usd(StormOperator):
    """Simulate falling leaves and write them as a USD point instancer (.usda)"""
    bl_idname, bl_label = "leaf_storm.export_usd", "Export USD"
    filepath: bpy.props.StringProperty(subtype="FILE_PATH", default="//leaf_storm.usda")

    def invoke(self, context, event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def work(self, context, storm):
        metres = metres_per_unit(context.scene)
        asset = lr.Asset.load(checked_path(storm.asset, "Asset"))
        recording = simulate(context.scene, asset, storm.settings())
        mesh = to_mesh(storm.leaf.data, metres).moved(-asset.info.center_of_mass)
        path = checked_path(self.filepath, "USD")
        write_usda(path, recording, mesh, up_axis="Z", names=[storm.leaf.name])
        return f"{len(recording)} frames: {path}"


class LEAFSTORM_PT_panel(bpy.types.Panel):
    bl_label, bl_idname = "Leaf Storm", "LEAFSTORM_PT_panel"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Leaves"

    def draw(self, context):
        storm, layout = context.scene.leaf_storm, self.layout
        layout.use_property_split = True
        parts = (("leaf", "asset", "density", "sheet"), ("count", "rate", "lifetime", "variation", "area", "seed"),
                 ("wind", "gusts", "turbulence"), ("ground", "ground_height", "obstacles", "heaps"), ("mode",))
        for part in parts:
            column = layout.column(align=True)
            for name in part:
                column.prop(storm, name)
            if part[0] == "leaf":
                if storm.sheet:
                    column.prop(storm, "thickness")
                column.operator(LEAFSTORM_OT_bake_asset.bl_idname)
        if storm.mode == "POINTS":
            layout.prop(storm, "cache")
        layout.operator(LEAFSTORM_OT_bake_storm.bl_idname, icon="PHYSICS")
        layout.operator(LEAFSTORM_OT_export_usd.bl_idname)


CLASSES = (StormProperties, LEAFSTORM_OT_bake_asset, LEAFSTORM_OT_bake_storm, LEAFSTORM_OT_export_usd, LEAFSTORM_PT_panel)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.leaf_storm = bpy.props.PointerProperty(type=StormProperties)


def unregister():
    del bpy.types.Scene.leaf_storm
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)


# The command.

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


def main(arguments):
    parser = argparse.ArgumentParser(prog="leaf_storm.py", description=__doc__.splitlines()[0])
    parser.add_argument("--mesh", required=True, help="OBJ mesh of a leaf, in metres")
    parser.add_argument("--asset", help="made by lr_bake from the same mesh; otherwise the command bakes it beside the cache")
    parser.add_argument("--density", type=float, default=350, help="density for the bake, kg/m^3")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--frames", type=int, default=96)
    parser.add_argument("--wind", type=float, nargs=3, default=(1.0, 0.0, 0.0), metavar=("X", "Y", "Z"), help="m/s")
    parser.add_argument("--size", type=float, nargs=3, default=(2.0, 2.0, 1.0), metavar=("X", "Y", "Z"), help="size of the spawn box, m")
    parser.add_argument("--height", type=float, default=2.0, help="center of the spawn box, m")
    parser.add_argument("--mode", choices=("points", "keyframes"), default="points")
    parser.add_argument("--cache", default="leaf_storm.pc2")
    parser.add_argument("--save", help=".blend file to write")
    parser.add_argument("--render", help="picture of frame --at, rendered by Cycles")
    parser.add_argument("--at", type=int, default=48)
    options = parser.parse_args(arguments)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, options.frames
    leaf = object_of(Mesh.read_obj(options.mesh), "Leaf")
    cache = os.path.abspath(options.cache)
    asset_path = options.asset or os.path.join(os.path.dirname(cache), "leaf_storm.lrb")
    if not options.asset:
        bake_asset(leaf, asset_path, scene, density=options.density)
    settings = Settings(count=options.count, wind=options.wind, center=(0, 0, options.height), size=options.size, gusts=0.5)
    recording, collection = bake_storm(scene, leaf, lr.Asset.load(asset_path), settings, options.mode.upper(), cache)
    print(f"leaf_storm: {len(recording)} frames, {options.count} leaves, {len(collection.objects)} objects")
    if options.render:
        import leaf_storm_picture
        at = min(max(options.at, 1), options.frames)
        middle = recording[at - 1].position.mean(axis=0) / metres_per_unit(scene)
        leaf_storm_picture.render(scene, leaf, at, middle.tolist(), os.path.abspath(options.render))
    if options.save:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(options.save))


if __name__ == "__main__":
    if bpy.app.background and "--" in sys.argv:
        sys.path.append(str(pathlib.Path(__file__).resolve().parent))
        register()
        try:
            main(sys.argv[sys.argv.index("--") + 1:])
        except (Problem, lr.Error, OSError) as problem:
            print(f"leaf_storm: {problem}", file=sys.stderr)
            sys.exit(1)
    else:
        register()
