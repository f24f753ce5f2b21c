# Run by Blender: renders a scene of planes, boxes, matte materials and rectangle lamps in glTF with Cycles, under the
# terms of `eyeray render --method path`: box filter of one pixel, nothing clamped, blurred or denoised.
# blender -b --factory-startup --python render.py -- SCENE.gltf OUT.exr WIDTH HEIGHT DEPTH SAMPLES SECONDS SEED THREADS
import json
import math
import sys
import time

import bpy
from mathutils import Matrix, Quaternion

path, out, width, height, depth, samples, seconds, seed, threads = sys.argv[sys.argv.index("--") + 1 :]
with open(path) as file:
    gltf = json.load(file)


def own(thing):
    return thing.get("extras", {}).get("eyeray", {})


def placement(node):
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    scale = Matrix.Diagonal([*node.get("scale", [1, 1, 1]), 1])
    return Matrix.Translation(node.get("translation", [0, 0, 0])) @ Quaternion((w, x, y, z)).to_matrix().to_4x4() @ scale


def place(name, corners, faces, material, transform):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(corners, [], faces)
    mesh.materials.append(material)
    thing = bpy.data.objects.new(name, mesh)
    thing.matrix_world = transform
    bpy.context.scene.collection.objects.link(thing)


def shape(entry):
    if entry["type"] == "plane":
        x, z = entry["plane"]["sizeX"] / 2, entry["plane"]["sizeZ"] / 2
        return [(-x, 0, -z), (-x, 0, z), (x, 0, z), (x, 0, -z)], [(0, 1, 2, 3)]
    x, y, z = (side / 2 for side in entry["box"]["size"])
    corners = [(i * x, j * y, k * z) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    return corners, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def nodes_of(material):
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    return tree, tree.nodes.new("ShaderNodeOutputMaterial")


def matte(entry):
    material = bpy.data.materials.new(entry["name"])
    tree, output = nodes_of(material)
    diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = [*own(entry)["taught"]["diffuse"], 1]
    tree.links.new(diffuse.outputs[0], output.inputs["Surface"])
    return material


def glowing(lamp):
    """Radiance on the front alone, which is black otherwise."""
    material = bpy.data.materials.new("lamp")
    tree, output = nodes_of(material)
    emission = tree.nodes.new("ShaderNodeEmission")
    emission.inputs["Color"].default_value = [*lamp["color"], 1]
    facing = tree.nodes.new("ShaderNodeNewGeometry")
    strength = tree.nodes.new("ShaderNodeMath")
    strength.operation = "MULTIPLY_ADD"  # intensity where it is not the back
    strength.inputs[1].default_value = -lamp["intensity"]
    strength.inputs[2].default_value = lamp["intensity"]
    tree.links.new(facing.outputs["Backfacing"], strength.inputs[0])
    tree.links.new(strength.outputs[0], emission.inputs["Strength"])
    tree.links.new(emission.outputs[0], output.inputs["Surface"])
    return material


def build():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    shapes = gltf["extensions"]["KHR_implicit_shapes"]["shapes"]
    materials = [matte(entry) for entry in gltf["materials"]]
    for node in gltf["nodes"]:
        told = own(node)
        if "shape" in told:
            place(node["name"], *shape(shapes[told["shape"]]), materials[told["material"]], placement(node))
        if "lamp" in told:
            x, y = told["lamp"]["width"] / 2, told["lamp"]["height"] / 2
            corners = [(-x, -y, 0), (-x, y, 0), (x, y, 0), (x, -y, 0)]  # it shines to its -z
            place(node["name"], corners, [(0, 1, 2, 3)], glowing(told["lamp"]), placement(node))
        if "camera" in node:
            seen = gltf["cameras"][node["camera"]]["perspective"]
            camera = bpy.data.cameras.new("camera")
            camera.sensor_fit = "VERTICAL"
            camera.angle = seen["yfov"]
            camera.clip_start = 0.01
            eye = bpy.data.objects.new("camera", camera)
            eye.matrix_world = placement(node)
            bpy.context.scene.collection.objects.link(eye)
            bpy.context.scene.camera = eye


def settings():
    scene = bpy.context.scene
    scene.world.use_nodes = False
    scene.world.color = (0, 0, 0)
    render = scene.render
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y = int(width), int(height)
    render.resolution_percentage = 100
    render.threads_mode, render.threads = "FIXED", int(threads)
    render.filepath = out
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_mode = "RGB"
    render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = int(samples)
    cycles.time_limit = float(seconds)
    cycles.seed = int(seed)
    cycles.use_denoising = cycles.use_adaptive_sampling = False
    cycles.pixel_filter_type = "BOX"
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.light_sampling_threshold = 0
    cycles.max_bounces = cycles.diffuse_bounces = int(depth)
    cycles.min_light_bounces = cycles.min_transparent_bounces = 0


build()
settings()
start = time.monotonic()
bpy.ops.render.render(write_still=True)
print(f"cycles seconds {time.monotonic() - start:.3f}")
