# SPDX-License-Identifier: MIT
"""Geometry nodes that draw the leaves: an instance on every third vertex of the carrier."""
import bpy

from .units import Problem

GROUP = "Leaf Storm Instances"
REALIZE = "Leaf Storm Mesh"


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


def new_group(name, leaf=False):
    """An empty tree with geometry in and out."""
    group = bpy.data.node_groups.new(name, "GeometryNodeTree")
    if hasattr(group, "interface"):  # Blender 4.0
        group.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        if leaf:
            group.interface.new_socket("Leaf", in_out="INPUT", socket_type="NodeSocketObject")
        group.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        group.inputs.new("NodeSocketGeometry", "Geometry")
        if leaf:
            group.inputs.new("NodeSocketObject", "Leaf")
        group.outputs.new("NodeSocketGeometry", "Geometry")
    return group


def realize_group():
    """Nodes that turn instances into one mesh."""
    group = bpy.data.node_groups.get(REALIZE)
    if group is None:
        group = new_group(REALIZE)
        start, real, end = (group.nodes.new(kind) for kind in ("NodeGroupInput", "GeometryNodeRealizeInstances", "NodeGroupOutput"))
        group.links.new(start.outputs[0], real.inputs[0])
        group.links.new(real.outputs[0], end.inputs[0])
    return group


def instance_group():
    """Builds nodes that instance the prototype on every third vertex, oriented and scaled by the two vertices after it."""
    group = new_group(GROUP, leaf=True)
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
