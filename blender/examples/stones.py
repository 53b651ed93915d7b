"""Renders stones with stripes; docs/blender.md shows the picture.

    blender --background --factory-startup --python stones.py -- --output FILE.jpg [--height H] [--samples N]
"""
import argparse
import math
import os
import sys

import addon_utils
import bpy
from mathutils import Vector, noise

addon_utils.enable("brindle_blender")

DOWN = Vector((0, 0, -1))
IVORY = (0.87, 0.82, 0.70)
# Size, turn, stripes and dark colour, from below.
STONES = [((1.25, 1.05, 0.55), 10, 46, (0.012, 0.035, 0.09)),
          ((0.92, 0.80, 0.46), 75, 38, (0.30, 0.055, 0.022)),
          ((0.62, 0.66, 0.36), 140, 30, (0.03, 0.085, 0.06)),
          ((0.36, 0.40, 0.27), 200, 22, (0.02, 0.02, 0.022))]


def put_down(obj, below):
    """Moves the object down until it touches the stone below, or the ground."""
    obj.location.z += 9
    bpy.context.view_layer.update()
    graph = bpy.context.evaluated_depsgraph_get()
    points = [obj.matrix_world @ vertex.co for vertex in obj.evaluated_get(graph).data.vertices]
    gap = min(point.z for point in points)
    if below is not None:
        lower, inverse = below.evaluated_get(graph), below.matrix_world.inverted()
        hits = [(point, lower.ray_cast(inverse @ point, inverse.to_3x3() @ DOWN)) for point in points]
        gap = min(point.z - (below.matrix_world @ place).z for point, (hit, place, *_) in hits if hit)
    obj.location.z -= gap + 0.02
    bpy.context.view_layer.update()


def stone(number, size, turn, stripes, dark, below):
    # Neither UV spheres nor modifiers that need normals have the same bits in every run.
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=7)
    obj = bpy.context.object
    bpy.ops.object.shade_smooth()
    for vertex in obj.data.vertices:
        vertex.co *= 1 + 0.24 * noise.noise(0.8 * vertex.co + Vector((3.7 * number, 1.9 * number, 5)))
    obj.scale, obj.location.x, obj.rotation_euler.z = size, 0.05 * (-1) ** number, math.radians(turn)
    put_down(obj, below)
    obj.brindle.stripes = stripes
    bpy.ops.brindle.make(kind="STRIPES")
    obj.active_material = obj.active_material.copy()
    nodes = obj.active_material.node_tree.nodes
    mix = next(node for node in nodes if node.type == "MIX_RGB")
    mix.inputs["Color1"].default_value, mix.inputs["Color2"].default_value = (*IVORY, 1), (*dark, 1)
    nodes["Principled BSDF"].inputs["Roughness"].default_value = 0.42
    return obj


def add(name, data, location=(0, 0, 0), target=None):
    """A new object that looks at the target."""
    obj = bpy.data.objects.new(name, data)
    obj.location = location
    if target is not None:
        obj.rotation_euler = (Vector(target) - obj.location).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(obj)
    return obj


def paper():
    """A floor that bends up into a wall."""
    arc = [math.radians(angle) for angle in range(0, 91, 5)]
    profile = [(-14, 0), *((2 + 4 * math.sin(a), 4 - 4 * math.cos(a)) for a in arc), (6, 30)]
    mesh = bpy.data.meshes.new("paper")
    mesh.from_pydata([(x, y, z) for y, z in profile for x in (-40, 40)], [],
                     [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(len(profile) - 1)])
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    material = bpy.data.materials.new("paper")
    material.use_nodes = True
    surface = material.node_tree.nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value, surface["Roughness"].default_value = (0.72, 0.66, 0.57, 1), 0.9
    mesh.materials.append(material)
    add("paper", mesh)


def light(location, size, power, color):
    lamp = bpy.data.lights.new("light", "AREA")
    lamp.size, lamp.energy, lamp.color = size, power, color
    add("light", lamp, location, (0, 0, 1.3))


def main(path, height, samples):
    scene = bpy.context.scene
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    below = None
    for number, parts in enumerate(STONES):
        below = stone(number, *parts, below)
    paper()
    light((-5, -4, 7), 2.5, 900, (1, 0.95, 0.88))
    light((6, -5, 3), 5, 90, (0.8, 0.88, 1))
    scene.camera = add("camera", bpy.data.cameras.new("camera"), (0.3, -11.5, 2.6), (0, 0, 1.5))
    scene.camera.data.lens = 98
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value, sky.inputs["Strength"].default_value = (0.9, 0.92, 1, 1), 0.25
    render, cycles = scene.render, scene.cycles
    render.engine, cycles.use_denoising, cycles.samples = "CYCLES", False, samples
    render.resolution_x, render.resolution_y, render.resolution_percentage = round(0.8 * height), height, 100
    render.image_settings.file_format, render.image_settings.quality = "JPEG", 88
    render.filepath = path
    scene.view_settings.view_transform, scene.view_settings.look = "Filmic", "Medium High Contrast"
    bpy.ops.render.render(write_still=True)


parser = argparse.ArgumentParser()
parser.add_argument("--output", required=True)
parser.add_argument("--height", type=int, default=900)
parser.add_argument("--samples", type=int, default=120)
given = parser.parse_args(sys.argv[sys.argv.index("--") + 1:])
main(os.path.abspath(given.output), given.height, given.samples)
