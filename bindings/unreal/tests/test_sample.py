#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the script that makes the sample map against a stand-in for the module `unreal`: test_sample.py PLUGIN

The engine's functions are those in NAMES, after the published Python reference. What belongs to the plugin must be in its headers."""
import re
import runpy
import sys
import types
from pathlib import Path

plugin = Path(sys.argv[1])
script = plugin / "Content/Python/langevin_sample.py"
headers = "".join(p.read_text() for p in plugin.glob("Source/*/Public/*.h"))
NAMES = {"AssetImportTask", "AssetToolsHelpers", "DirectionalLight", "EditorActorSubsystem", "EditorAssetLibrary", "LevelEditorSubsystem",
         "PlayerStart", "Rotator", "SkyLight", "StaticMesh", "Vector", "WindDirectionalSource", "WindDirectionalSourceComponent",
         "get_editor_subsystem", "load_asset", "log"}
ours = {m for m in re.findall(r"unreal\.(\w+)", script.read_text()) if m.startswith("Langevin")}
assert not set(re.findall(r"unreal\.(\w+)", script.read_text())) - NAMES - ours, "a name of the engine that is not in NAMES"
for name in ours:
    assert re.search(rf"class LANGEVIN\w+_API [UA]{name} ", headers), f"the plugin has no {name}"


def property_of(name):
    """respawn is bRespawn, max_age is MaxAge."""
    words = "".join(word.capitalize() for word in name.split("_"))
    return re.search(rf"UPROPERTY\([^)]*(?:\([^)]*\)[^)]*)*Edit\w+.*?\n.*\b(b?{words})\b", headers)


done = []


class Thing:
    def __init__(self, *arguments):
        self.arguments = arguments

    def __getattr__(self, name):
        return lambda *arguments: done.append((name, arguments)) or True


class Mesh(Thing):
    def __init__(self, length):
        self.length = length

    def get_bounding_box(self):
        return types.SimpleNamespace(min=types.SimpleNamespace(x=-self.length / 2), max=types.SimpleNamespace(x=self.length / 2))


class Component(Thing):
    def set_editor_property(self, name, value):
        assert property_of(name), f"the batch has no {name}"
        done.append((name, value))


class Actor(Thing):
    def get_component_by_class(self, kind):
        return Component() if kind.__name__ == "LangevinBatchComponent" else Thing()


class Actors(Thing):
    def spawn_actor_from_class(self, kind, at, turn=None):
        done.append(("spawn", kind.__name__))
        return Actor()

    def spawn_actor_from_object(self, asset, at, turn=None):
        done.append(("spawn", "object"))
        return Actor()


class Bake:
    @staticmethod
    def bake_static_mesh(mesh, density, thickness):
        assert re.search(r"static ULangevinAsset\* BakeStaticMesh\(UStaticMesh\* Mesh, float Density = .*, float SheetThickness", headers)
        return Thing()


def run(length):
    done.clear()
    unreal = types.ModuleType("unreal")
    for name in NAMES | ours:
        setattr(unreal, name, type(name, (Thing,), {}))
    unreal.StaticMesh, unreal.LangevinBake = Mesh, Bake
    unreal.load_asset = lambda path: Mesh(length)
    unreal.get_editor_subsystem = lambda kind: Actors() if kind.__name__ == "EditorActorSubsystem" else Thing()
    unreal.AssetToolsHelpers.get_asset_tools = staticmethod(Thing)
    unreal.EditorAssetLibrary.save_loaded_asset = staticmethod(lambda asset: True)
    unreal.log = lambda text: done.append(("log", text))
    sys.modules["unreal"] = unreal
    runpy.run_path(str(script), run_name="__main__")


leaf = [line.split() for line in (plugin / "Content/Python/leaf.obj").read_text().splitlines() if line.startswith("v ")]
length = max(float(v[1]) for v in leaf) - min(float(v[1]) for v in leaf)
run(length)
assert sum(entry == ("spawn", "object") for entry in done) == 4 and ("spawn", "LangevinBatchActor") in done
assert done[-1][0] == "log" and any(name == "save_current_level" for name, _ in done)
try:
    run(100 * length)
    sys.exit("a leaf of another size was taken")
except RuntimeError as error:
    assert "cm long instead of 7" in str(error)
print(f"{len(ours)} classes of the plugin, leaf of {length:.2f} cm")
