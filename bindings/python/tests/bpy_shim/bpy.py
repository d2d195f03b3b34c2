# SPDX-License-Identifier: MIT
"""The part of Blender's bpy that the add-on uses without a window. Properties, nodes and sockets are those of Blender 3.4; all others
are refused, so that the add-on cannot use an invented one. It draws nothing: tests/blender_check.py runs in a real Blender."""
import types as _types

import numpy as np


class Strict:
    """Refuses values for properties that it does not have."""

    def __init__(self, **properties):
        object.__setattr__(self, "__dict__", dict(properties))

    def __setattr__(self, name, value):
        if name not in self.__dict__:
            raise AttributeError(f"{type(self).__name__} has no {name}")
        self.__dict__[name] = value


class Elements:
    """A collection of elements with flat arrays of their properties."""

    def __init__(self, **widths):
        self.widths, self.arrays, self.count = widths, {}, 0

    def __len__(self):
        return self.count

    def add(self, count):
        self.count += count

    def foreach_get(self, name, out):
        if out.size != self.count * self.widths[name]:
            raise RuntimeError("internal error setting the array")
        out[:] = self.arrays[name]

    def foreach_set(self, name, values):
        if len(values) != self.count * self.widths[name]:
            raise RuntimeError("internal error setting the array")
        self.arrays[name] = np.array(values).ravel()


class Mesh:
    def __init__(self, name):
        self.name, self.vertices, self.loop_triangles = name, Elements(co=3), Elements(vertices=3)
        self.polygons, self.faces = Elements(use_smooth=1), []
        self.uv_layers = _types.SimpleNamespace(new=self.new_uv)

    def new_uv(self, name):
        data = Elements(uv=2)
        data.add(sum(map(len, self.faces)))
        return _types.SimpleNamespace(name=name, data=data)

    def from_pydata(self, points, edges, faces):
        self.vertices.add(len(points))
        self.vertices.foreach_set("co", np.array(points, np.float32).ravel())
        self.faces = [tuple(face) for face in faces]
        self.polygons.add(len(faces))

    def calc_loop_triangles(self):
        triangles = [(f[0], f[i], f[i + 1]) for f in self.faces for i in range(1, len(f) - 1)]
        self.loop_triangles = Elements(vertices=3)
        self.loop_triangles.add(len(triangles))
        self.loop_triangles.foreach_set("vertices", np.array(triangles, np.int32).ravel())

    def update(self):
        pass

    def copy(self):
        other = Mesh(self.name + ".001")
        other.from_pydata(self.vertices.arrays["co"].reshape(-1, 3), [], self.faces)
        return other

    def transform(self, matrix):
        points = self.vertices.arrays["co"].reshape(-1, 3) @ matrix.values[:3, :3].T + matrix.values[:3, 3]
        self.vertices.arrays["co"] = points.astype(np.float32).ravel()


class Modifier(Strict):
    def __init__(self, kind):
        caches = {"cache_format": "MDD", "filepath": "", "time_mode": "FRAME", "play_mode": "SCENE", "interpolation": "LINEAR",
                  "frame_start": 0.0, "frame_scale": 1.0}
        super().__init__(type=kind, **({"MESH_CACHE": caches, "NODES": {"node_group": None}}[kind]))
        self.__dict__["inputs"] = {}

    def __setitem__(self, identifier, value):
        if identifier not in {item.identifier for item in self.node_group.inputs}:
            raise KeyError(identifier)
        self.inputs[identifier] = value


class Keyframe(Strict):
    pass


class Curve:
    def __init__(self, path, index):
        self.data_path, self.array_index, self.keyframe_points = path, index, Keyframes()

    def update(self):
        pass


class Keyframes(Elements):
    def __init__(self):
        super().__init__(co=2)

    def __iter__(self):
        return (Keyframe(interpolation="BEZIER") for _ in range(self.count))


class Action:
    def __init__(self, name):
        self.name, self.curves = name, []
        self.fcurves = _types.SimpleNamespace(new=self.new_curve)

    def new_curve(self, path, index=0, action_group=""):
        if any((c.data_path, c.array_index) == (path, index) for c in self.curves):
            raise RuntimeError(f"F-Curve '{path}[{index}]' already exists")
        self.curves.append(Curve(path, index))
        return self.curves[-1]


class Stack:
    """The modifiers of an object."""

    def __init__(self, stack):
        self.stack = stack

    def __len__(self):
        return len(self.stack)

    def new(self, name, kind):
        self.stack.append(Modifier(kind))
        return self.stack[-1]

    def remove(self, modifier):
        self.stack.remove(modifier)


class Object(Strict):
    def __init__(self, name, mesh):
        super().__init__(name=name, data=mesh, scale=(1.0, 1.0, 1.0), rotation_mode="XYZ", hide_render=False, hide_viewport=False,
                         field=None, collision=None, type="MESH", selected=False, hidden=False, action=Strict(action=None), stack=[])
        self.__dict__["modifiers"] = Stack(self.stack)

    def hide_set(self, on, view_layer=None):
        self.hidden = on

    def select_get(self):
        return self.selected

    def select_set(self, on):
        self.selected = on

    def animation_data_create(self):
        return self.action


class Links(list):
    link = list.append


NODES = {  # inputs and outputs in use; properties
    "NodeGroupInput": ((), (), {}), "NodeGroupOutput": ((), (), {}),
    "GeometryNodeInputIndex": ((), ("Index",), {}), "GeometryNodeInputPosition": ((), ("Position",), {}),
    "ShaderNodeMath": (("Value", "Value", "Value"), ("Value",), {"operation": {"MODULO", "LESS_THAN", "ADD"}}),
    "ShaderNodeVectorMath": (("Vector", "Vector"), ("Vector", "Value"), {"operation": {"SUBTRACT", "CROSS_PRODUCT", "LENGTH"}}),
    "GeometryNodeFieldAtIndex": (("Index", "Value"), ("Value",), {"data_type": {"FLOAT_VECTOR"}, "domain": {"POINT"}}),
    "FunctionNodeAlignEulerToVector": (("Rotation", "Factor", "Vector"), ("Rotation",),
                                       {"axis": {"X", "Y", "Z"}, "pivot_axis": {"AUTO", "X", "Y", "Z"}}),
    "GeometryNodeRealizeInstances": (("Geometry",), ("Geometry",), {}),
    "GeometryNodeObjectInfo": (("Object", "As Instance"), ("Location", "Rotation", "Scale", "Geometry"),
                               {"transform_space": {"ORIGINAL", "RELATIVE"}}),
    "GeometryNodeInstanceOnPoints": (("Points", "Selection", "Instance", "Pick Instance", "Instance Index", "Rotation", "Scale"),
                                     ("Instances",), {}),
}


class Sockets(list):
    def __getitem__(self, at):
        if isinstance(at, int):
            return super().__getitem__(at)
        found = [socket for socket in self if socket.name == at]
        if not found:
            raise KeyError(f'bpy_prop_collection[key]: key "{at}" not found')
        return found[0]

    def new(self, kind, name):
        self.append(Strict(name=name, identifier=f"Input_{len(self)}", enabled=True, default_value=None, kind=kind))


class Node(Strict):
    def __init__(self, kind, tree):
        if kind not in NODES:
            raise RuntimeError(f"Error: Node type {kind} undefined")
        inputs, outputs, self.__dict__["allowed"] = NODES[kind]
        super().__init__(kind=kind, location=(0, 0), allowed=NODES[kind][2], **{name: None for name in NODES[kind][2]},
                         inputs=self.sockets(inputs), outputs=self.sockets(outputs))
        if kind == "NodeGroupInput":
            self.__dict__["outputs"] = tree.inputs
        if kind == "NodeGroupOutput":
            self.__dict__["inputs"] = tree.outputs

    @staticmethod
    def sockets(names):
        return Sockets(Strict(name=name, identifier=name, enabled=True, default_value=None) for name in names)

    def __setattr__(self, name, value):
        if name in self.allowed and value not in self.allowed[name]:
            raise TypeError(f'enum "{value}" not found')
        super().__setattr__(name, value)


class Tree:
    def __init__(self, name, kind):
        self.name, self.inputs, self.outputs, self.linked, self.made = name, Sockets(), Sockets(), [], []
        self.nodes = _types.SimpleNamespace(new=self.new_node)
        self.links = _types.SimpleNamespace(new=lambda start, end: self.linked.append((start, end)))

    def new_node(self, kind):
        self.made.append(Node(kind, self))
        return self.made[-1]


class Table(dict):
    def __init__(self, make):
        super().__init__()
        self.make = make

    def new(self, name, *arguments):
        made = self.make(name, *arguments)
        while made.name in self:
            made.name += ".001"
        self[made.name] = made
        return made

    def remove(self, thing, do_unlink=False):
        del self[thing.name]


def new_collection(name):
    return _types.SimpleNamespace(name=name, objects=Links())


class Scene:
    def __init__(self):
        self.frame_start, self.frame_end, self.frame_current = 1, 250, 1
        self.render = Strict(fps=24, fps_base=1.0)
        self.unit_settings = Strict(system="METRIC", scale_length=1.0)
        self.view_layers = ["ViewLayer"]
        self.gravity, self.use_gravity, self.objects = (0.0, 0.0, -9.81), True, []
        self.collection = _types.SimpleNamespace(objects=Links(), children=Links())

    def frame_set(self, frame):
        self.frame_current = frame


class Base:
    pass


types = _types.SimpleNamespace(PropertyGroup=Base, Operator=Base, Panel=Base, Scene=type("Scene", (), {}), Object=Base, Collection=Base)
props = _types.SimpleNamespace(**{name: (lambda **options: options) for name in (
    "PointerProperty", "StringProperty", "FloatProperty", "IntProperty", "BoolProperty", "FloatVectorProperty", "EnumProperty")})
utils = _types.SimpleNamespace(register_class=lambda kind: None, unregister_class=lambda kind: None,
                               user_resource=lambda kind, path="": "/" + path)
app = Strict(background=False, version_string="3.4", build_options=Strict(alembic=True, usd=False))
path = _types.SimpleNamespace(abspath=lambda name: name)
data = _types.SimpleNamespace(meshes=Table(Mesh), objects=Table(Object), collections=Table(new_collection), node_groups=Table(Tree),
                              actions=Table(Action), filepath="")


class Layer:
    def __init__(self):
        self.objects = LayerObjects()


class LayerObjects:
    active = None

    def __iter__(self):
        return iter(data.objects.values())


context = _types.SimpleNamespace(scene=Scene(), view_layer=Layer())
exported = []


def alembic_export(filepath, selected, start, end, evaluation_mode, as_background_job, check_existing):
    """Notes what would be written: names of the selected objects, and node groups of their modifiers."""
    things = [thing for thing in data.objects.values() if thing.selected]
    exported.append(([thing.name for thing in things], [m.node_group.name for t in things for m in t.stack if m.type == "NODES"],
                     start, end, evaluation_mode))
    with open(filepath, "wb") as file:
        file.write(b"Ogawa")
    return {"FINISHED"}


ops = _types.SimpleNamespace(wm=_types.SimpleNamespace(alembic_export=alembic_export))
