# SPDX-License-Identifier: MIT
"""Lights, ground, camera and materials for a picture of a storm, rendered by Cycles on the CPU."""
import math

import bpy
from mathutils import Vector


def material(name, color, roughness, translucent=0.0):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = (*color, 1)
    shader.inputs["Roughness"].default_value = roughness
    if translucent:
        through = nodes.new("ShaderNodeBsdfTranslucent")
        through.inputs["Color"].default_value = (*[min(1.6 * c, 1) for c in color], 1)
        mix = nodes.new("ShaderNodeMixShader")
        mix.inputs[0].default_value = translucent
        output = next(node for node in nodes if node.type == "OUTPUT_MATERIAL")
        links.new(shader.outputs[0], mix.inputs[1])
        links.new(through.outputs[0], mix.inputs[2])
        links.new(mix.outputs[0], output.inputs["Surface"])
    return made


def paint(leaf):
    """An autumn material: each instance has its own colour."""
    made = material("Leaf", (0.6, 0.25, 0.05), 0.5, 0.35)
    nodes, links = made.node_tree.nodes, made.node_tree.links
    random, ramp = nodes.new("ShaderNodeObjectInfo"), nodes.new("ShaderNodeValToRGB")
    ramp.color_ramp.elements[0].color, ramp.color_ramp.elements[1].color = (0.45, 0.06, 0.02, 1), (0.75, 0.45, 0.05, 1)
    links.new(random.outputs["Random"], ramp.inputs[0])
    for node in nodes:
        if node.type in ("BSDF_PRINCIPLED", "BSDF_TRANSLUCENT"):
            links.new(ramp.outputs[0], node.inputs[0])
    leaf.materials.clear()
    leaf.materials.append(made)


def render_frame(scene, frame, path):
    scene.render.filepath = path
    scene.frame_set(frame)
    bpy.ops.render.render(write_still=True)


def render(scene, leaf, frame, middle, path, width=560, height=340, samples=48):
    """middle: the point at which the camera aims, in Blender's units."""
    for thing in scene.objects:
        if thing.name in ("Cube", "Light"):
            thing.hide_render = True
    for mesh in {thing.data for thing in bpy.data.objects if thing.type == "MESH" and len(thing.data.polygons)}:
        if mesh.name.startswith(leaf.name):
            paint(mesh)
    ground = bpy.data.meshes.new("Ground")
    ground.from_pydata([(-40, -40, 0), (40, -40, 0), (40, 40, 0), (-40, 40, 0)], [], [(0, 1, 2, 3)])
    ground.materials.append(material("Ground", (0.1, 0.13, 0.06), 0.9))
    scene.collection.objects.link(bpy.data.objects.new("Ground", ground))
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy, sun.data.angle = 3.5, 0.02
    sun.rotation_euler = (math.radians(50), 0, math.radians(130))
    scene.collection.objects.link(sun)
    world = bpy.data.worlds.new("Sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.55, 0.7, 0.9, 1)
    world.node_tree.nodes["Background"].inputs[1].default_value = 0.6
    scene.world = world
    camera = bpy.data.objects.new("Camera of the storm", bpy.data.cameras.new("Camera of the storm"))
    camera.location = Vector(middle) + Vector((0.4, -2.4, 0.1))
    camera.rotation_euler = (Vector(middle) - camera.location).to_track_quat("-Z", "Y").to_euler()
    camera.data.lens = 32
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", samples, False
    scene.render.use_motion_blur = True
    scene.render.motion_blur_shutter = 0.4
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.image_settings.file_format = "PNG"
    render_frame(scene, frame, path)
