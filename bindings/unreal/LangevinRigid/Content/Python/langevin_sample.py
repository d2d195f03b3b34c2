# Copyright Langevin Rigid contributors. SPDX-License-Identifier: MIT
"""Makes the sample map /Game/LangevinRigid/LeafStorm: a leaf is imported, baked, and falls over a floor with boxes in wind.

In the editor: Tools > Execute Python Script, or in the output log: py langevin_sample.py
Without it:    UnrealEditor-Cmd PROJECT.uproject -run=pythonscript -script=PLUGIN/Content/Python/langevin_sample.py
It needs the plugin Python Editor Script Plugin."""
import os

import unreal

FOLDER = "/Game/LangevinRigid"


def import_leaf():
    task = unreal.AssetImportTask()
    for name, value in (("filename", os.path.join(os.path.dirname(os.path.abspath(__file__)), "leaf.obj")), ("destination_path", FOLDER),
                        ("automated", True), ("replace_existing", True), ("save", True)):
        task.set_editor_property(name, value)
    unreal.AssetToolsHelpers.get_asset_tools().import_asset_tasks([task])
    mesh = unreal.load_asset(FOLDER + "/leaf")
    if not isinstance(mesh, unreal.StaticMesh):
        raise RuntimeError("leaf.obj was not imported as a static mesh: see the log")
    size = mesh.get_bounding_box().max.x - mesh.get_bounding_box().min.x
    if not 6.0 < size < 8.0:
        # OBJ files have no unit, and importers differ: the file is in centimetres.
        raise RuntimeError(f"the leaf is {size} cm long instead of 7: import {FOLDER}/leaf again with scale {7.0 / size}")
    return mesh


def place(actors, asset, at, scale, label):
    actor = actors.spawn_actor_from_object(asset, unreal.Vector(*at))
    actor.set_actor_scale3d(unreal.Vector(*scale))
    actor.set_actor_label(label)
    return actor


def main():
    mesh = import_leaf()
    asset = unreal.LangevinBake.bake_static_mesh(mesh, 350.0, 0.0)
    if asset is None:
        raise RuntimeError("the leaf was not baked: see the log")
    unreal.EditorAssetLibrary.save_loaded_asset(asset)

    levels = unreal.get_editor_subsystem(unreal.LevelEditorSubsystem)
    actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    if not levels.new_level(FOLDER + "/LeafStorm"):
        raise RuntimeError(f"{FOLDER}/LeafStorm exists already: delete it to make it anew")
    cube = unreal.load_asset("/Engine/BasicShapes/Cube")
    place(actors, cube, (0, 0, -50), (20, 20, 1), "Floor")
    for number in range(3):
        place(actors, cube, (-200 + 200 * number, 100, 50), (1, 1, 1), f"Box{number + 1}")
    actors.spawn_actor_from_class(unreal.DirectionalLight, unreal.Vector(0, 0, 500), unreal.Rotator(0, -45, -40))
    actors.spawn_actor_from_class(unreal.SkyLight, unreal.Vector(0, 0, 500))
    actors.spawn_actor_from_class(unreal.PlayerStart, unreal.Vector(-800, 0, 100))
    wind = actors.spawn_actor_from_class(unreal.WindDirectionalSource, unreal.Vector(0, -300, 200), unreal.Rotator(0, 0, 60))
    wind.get_component_by_class(unreal.WindDirectionalSourceComponent).set_editor_property("speed", 0.15)

    leaves = actors.spawn_actor_from_class(unreal.LangevinBatchActor, unreal.Vector(0, 0, 400))
    leaves.set_actor_label("Leaves")
    batch = leaves.get_component_by_class(unreal.LangevinBatchComponent)
    for name, value in (("asset", asset), ("capacity", 5000), ("initial_count", 5000), ("emitter_extent", unreal.Vector(600, 600, 200)),
                        ("max_age", 20.0), ("respawn", True)):
        batch.set_editor_property(name, value)
    batch.set_static_mesh(mesh)
    if not levels.save_current_level():
        raise RuntimeError("the level was not saved")
    unreal.log(f"{FOLDER}/LeafStorm is made: open it and press Play")


if __name__ == "__main__":
    main()
