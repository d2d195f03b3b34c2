# SPDX-License-Identifier: MIT
"""The panel, its properties, and their registration."""
import bpy
import numpy as np
from mathutils import Vector

from . import colliders
from .operators import LEAFSTORM_OT_bake_asset, LEAFSTORM_OT_bake_storm, LEAFSTORM_OT_export
from .simulate import Settings
from .wind import fields_of


class StormProperties(bpy.types.PropertyGroup):
    leaf: bpy.props.PointerProperty(name="Leaf", type=bpy.types.Object, poll=lambda self, thing: thing.type == "MESH",
                                    description="The mesh that falls, at its true size, with its scale applied")
    asset: bpy.props.StringProperty(name="Asset", subtype="FILE_PATH", default="//leaf.lrb", description="Asset file made by lr_bake")
    density: bpy.props.FloatProperty(name="Density", default=350, min=0.1, description="Density of the leaf, kg/m^3, used by the bake")
    sheet: bpy.props.BoolProperty(name="Open sheet", description="The mesh is the middle surface of a sheet, without thickness")
    thickness: bpy.props.FloatProperty(name="Thickness", default=0.3, min=0.001, description="Thickness of the sheet, mm")
    emitter: bpy.props.PointerProperty(name="Emitter", type=bpy.types.Object, description="Leaves spawn in this object's bounding box; "
                                       "without an object, in a box of 4 x 4 x 1 at a height of 3")
    colliders: bpy.props.PointerProperty(name="Colliders", type=bpy.types.Collection, description="Leaves land on the meshes of this "
                                         "collection, besides all objects with Collision physics")
    friction: bpy.props.FloatProperty(name="Friction", default=0.6, min=0, max=10, description="Of leaves on colliders and on the ground")
    count: bpy.props.IntProperty(name="Leaves", default=1000, min=1, max=1000000)
    rate: bpy.props.FloatProperty(name="Rate", default=0, min=0, description="Leaves spawned per second; 0 spawns all at the start")
    lifetime: bpy.props.FloatProperty(name="Lifetime", default=0, min=0, description="Seconds until a leaf disappears; 0: never")
    variation: bpy.props.FloatProperty(name="Variation", default=0.2, min=0, max=0.9, description="Relative variation of size between leaves")
    seed: bpy.props.IntProperty(name="Seed", default=0, min=0)
    wind: bpy.props.FloatVectorProperty(name="Wind", subtype="XYZ", description="Uniform wind, m/s. The scene's force fields "
                                         "of types Wind, Vortex and Turbulence are added; their strength counts as m/s")
    gusts: bpy.props.FloatProperty(name="Gusts", default=0.5, min=0, description="Root mean square of gusts, m/s")
    turbulence: bpy.props.FloatProperty(name="Turbulence", default=0.3, min=0, description="Root mean square of turbulence, m/s")
    ground: bpy.props.BoolProperty(name="Ground", default=True, description="An endless plane, besides the colliders")
    ground_height: bpy.props.FloatProperty(name="Height", default=0)
    heaps: bpy.props.BoolProperty(name="Heaps", description="Leaves collide with each other and pile up")
    mode: bpy.props.EnumProperty(name="Output", items=[
        ("POINTS", "Instances", "One object with a point cache and geometry nodes: any number of leaves"),
        ("KEYFRAMES", "Keyframes", "An object for each leaf: up to a few hundred, for editing by hand")])
    cache: bpy.props.StringProperty(name="Cache", subtype="FILE_PATH", default="//leaf_storm.pc2")

    def settings(self, scene):
        values = {name: getattr(self, name) for name in ("count", "rate", "lifetime", "variation", "seed", "gusts", "turbulence",
                                                         "ground", "ground_height", "heaps", "friction")}
        if self.emitter is not None:
            corners = np.array([self.emitter.matrix_world @ Vector(corner) for corner in self.emitter.bound_box])
            values.update(center=(corners.min(0) + corners.max(0)) / 2, size=np.ptp(corners, axis=0))
        return Settings(wind=tuple(self.wind), colliders=colliders.of_scene(scene, self.colliders, (self.leaf,)), **values)


class LEAFSTORM_PT_panel(bpy.types.Panel):
    bl_label, bl_idname = "Leaf Storm", "LEAFSTORM_PT_panel"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Leaves"

    def draw(self, context):
        storm, layout = context.scene.leaf_storm, self.layout
        layout.use_property_split, layout.use_property_decorate = True, False
        parts = (("leaf", "asset", "density", "sheet"), ("count", "rate", "lifetime", "variation", "emitter", "seed"),
                 ("wind", "gusts", "turbulence"), ("ground", "ground_height", "colliders", "friction", "heaps"), ("mode",))
        for part in parts:
            column = layout.column(align=True)
            for name in part:
                column.prop(storm, name)
            if part[0] == "leaf":
                if storm.sheet:
                    column.prop(storm, "thickness")
                column.operator(LEAFSTORM_OT_bake_asset.bl_idname)
            if part[0] == "wind":
                column.label(text=f"{len(fields_of(context.scene)[0])} wind fields in the scene", icon="FORCE_WIND")
            if part[0] == "ground":
                found = colliders.of_scene(context.scene, storm.colliders, (storm.leaf,))
                column.label(text=f"{len(found)} colliders in the scene", icon="MOD_PHYSICS")
        if storm.mode == "POINTS":
            layout.prop(storm, "cache")
        layout.operator(LEAFSTORM_OT_bake_storm.bl_idname, icon="PHYSICS")
        layout.operator(LEAFSTORM_OT_export.bl_idname, icon="EXPORT")


CLASSES = (StormProperties, LEAFSTORM_OT_bake_asset, LEAFSTORM_OT_bake_storm, LEAFSTORM_OT_export, LEAFSTORM_PT_panel)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.leaf_storm = bpy.props.PointerProperty(type=StormProperties)


def unregister():
    del bpy.types.Scene.leaf_storm
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
