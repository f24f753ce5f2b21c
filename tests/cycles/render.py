# Run by Blender: renders a scene in glTF of the kinds that shapes.py and materials.py know with Cycles, under the terms of
# `eyeray render --method path`: box filter of one pixel, nothing clamped, blurred or denoised.
# blender -b --factory-startup --python render.py -- SCENE.gltf OUT.exr WIDTH HEIGHT DEPTH SAMPLES SECONDS SEED THREADS
import json
import os
import sys
import time

import bpy
from mathutils import Matrix, Quaternion

sys.path.append(os.path.dirname(os.path.abspath(__file__)))
import materials
import shapes

path, out, width, height, depth, samples, seconds, seed, threads = sys.argv[sys.argv.index("--") + 1 :]
with open(path) as file:
    gltf = json.load(file)
kinds = gltf["extensions"]["KHR_implicit_shapes"]["shapes"]


def own(thing):
    return thing.get("extras", {}).get("eyeray", {})


def placement(node):
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    scale = Matrix.Diagonal([*node.get("scale", [1, 1, 1]), 1])
    return Matrix.Translation(node.get("translation", [0, 0, 0])) @ Quaternion((w, x, y, z)).to_matrix().to_4x4() @ scale


def place(name, data, node):
    thing = bpy.data.objects.new(name, data)
    thing.matrix_world = placement(node)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def ball(node):
    """Its radius, 0 of what is none."""
    return kinds[own(node)["shape"]].get("sphere", {}).get("radius", 0) if "shape" in own(node) else 0


def around(node):
    """Refractive index around a ball: of the smallest one with the same centre that it is in. Eyeray finds it ray by ray."""
    holds = [other for other in gltf["nodes"] if ball(other) > ball(node) > 0 and other["translation"] == node["translation"]]
    return own(gltf["materials"][own(min(holds, key=ball))["material"]])["taught"]["ior"] if holds else 1


def build():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    for node in gltf["nodes"]:
        told, name = own(node), node["name"]
        if "shape" in told:
            mesh = shapes.mesh(kinds[told["shape"]])
            mesh.materials.append(materials.surface(own(gltf["materials"][told["material"]]), around(node)))
            place(name, mesh, node)
        if "lamp" in told:
            mesh = shapes.lamp(told["lamp"])
            mesh.materials.append(materials.glowing(told["lamp"]))
            place(name, mesh, node)
        if "KHR_lights_punctual" in node.get("extensions", {}):
            number = node["extensions"]["KHR_lights_punctual"]["light"]
            place(name, materials.point_lamp(gltf["extensions"]["KHR_lights_punctual"]["lights"][number]), node)
        if node.get("camera") == 0:
            bpy.context.scene.camera = place(name, camera(gltf["cameras"][0]["perspective"]), node)
    materials.sky(bpy.context.scene.world, own(gltf["scenes"][0]).get("environment", {}))


def camera(seen):
    result = bpy.data.cameras.new("camera")
    result.sensor_fit = "VERTICAL"
    result.angle = seen["yfov"]
    result.clip_start = 0.01
    return result


def settings():
    scene = bpy.context.scene
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
    cycles.glossy_bounces = cycles.transmission_bounces = int(depth)
    cycles.min_light_bounces = cycles.min_transparent_bounces = 0


build()
settings()
start = time.monotonic()
bpy.ops.render.render(write_still=True)
print(f"cycles seconds {time.monotonic() - start:.3f}")
