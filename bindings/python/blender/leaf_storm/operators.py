# SPDX-License-Identifier: MIT
"""Operators of the panel."""
import bpy
import langevin_rigid as lr

from . import caches
from .leaf import bake_asset
from .storm import bake_storm
from .units import Problem
from .wind import fields_of


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
        settings, (blowing, ignored) = storm.settings(context.scene), fields_of(context.scene)
        context.window_manager.progress_begin(0, 1)
        try:
            recording, _ = bake_storm(context.scene, storm.leaf, asset, settings, storm.mode, storm.cache,
                                      context.window_manager.progress_update)
        finally:
            context.window_manager.progress_end()
        said = (f"{max(len(frame.ids) for frame in recording)} leaves, {len(recording)} frames, {len(settings.colliders)} colliders, "
                f"{len(blowing)} wind fields")
        return said + ("; not wind: " + ", ".join(f"{thing.name} ({thing.field.type})" for thing in ignored) if ignored else "")


class LEAFSTORM_OT_export(StormOperator):
    """Write the storm for other programs: Alembic (.abc) or USD (.usd, .usdc) by Blender, or a USD point instancer (.usda)"""
    bl_idname, bl_label = "leaf_storm.export", "Export"
    filepath: bpy.props.StringProperty(subtype="FILE_PATH", default="//leaf_storm.abc")

    def invoke(self, context, event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def work(self, context, storm):
        path = checked_path(self.filepath, "Export")
        if caches.kind_of(path) in caches.BY_BLENDER:
            caches.export_by_blender(context.scene, path)
        else:
            asset = lr.Asset.load(checked_path(storm.asset, "Asset"))
            caches.export_points(context.scene, storm.leaf, asset, storm.settings(context.scene), path)
        return path
