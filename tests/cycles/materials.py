# Taught materials, lamps and skies of Eyeray as nodes of Cycles, as `path` takes them.
import math

import bpy


def nodes_of(thing, output):
    thing.use_nodes = True
    tree = thing.node_tree
    tree.nodes.clear()
    return tree, tree.nodes.new(output)


def add(tree, kind, **inputs):
    """A node with these inputs: a value, or the output of another node."""
    node = tree.nodes.new(kind)
    for name, value in inputs.items():
        plug(tree, node.inputs[name.replace("_", " ")], value)
    return node


def plug(tree, socket, value):
    if isinstance(value, bpy.types.NodeSocket):
        tree.links.new(value, socket)
    else:
        socket.default_value = [*value, 1] if isinstance(value, list) else value


def math_node(tree, operation, *values):
    node = tree.nodes.new("ShaderNodeMath")
    node.operation = operation
    for socket, value in zip(node.inputs, values):
        plug(tree, socket, value)
    return node.outputs[0]


def times(a, b):
    return [x * y for x, y in zip(a, b)]


def checker(tree, entry, reflectance):
    """Colour of the plane's cells, by its own x and z."""
    at = add(tree, "ShaderNodeSeparateXYZ", Vector=add(tree, "ShaderNodeTexCoord").outputs["Object"])
    across, along = (math_node(tree, "MULTIPLY", at.outputs[axis], cells) for axis, cells in zip("XZ", entry["cells"]))
    place = add(tree, "ShaderNodeCombineXYZ", X=across, Y=along, Z=1.5)  # in this layer Color1 is that of the cell at 0
    colors = {f"Color{i}": times(entry[name], reflectance) for i, name in ((1, "even"), (2, "odd"))}
    return add(tree, "ShaderNodeTexChecker", Vector=place.outputs[0], Scale=1.0, **colors).outputs["Color"]


def glass(tree, taught, around):
    """The same share of what Fresnel reflects and of what it lets pass; the rest is lost. `around` counts from outside."""
    through = [r + t for r, t in zip(taught.get("reflectivity", [0, 0, 0]), taught["transmission"])]
    node = add(tree, "ShaderNodeBsdfGlass", Color=through, IOR=taught["ior"] / around)
    node.distribution = "SHARP"
    return node.outputs[0]


def opaque(tree, entry):
    """Diffuse, and a perfect mirror that is as bright under each angle."""
    taught = entry["taught"]
    color = checker(tree, entry["checker"], taught["diffuse"]) if "checker" in entry else taught["diffuse"]
    body = add(tree, "ShaderNodeBsdfDiffuse", Color=color).outputs[0]
    if not any(taught.get("reflectivity", [])):
        return body
    mirror = add(tree, "ShaderNodeBsdfGlossy", Color=taught["reflectivity"])
    mirror.distribution = "SHARP"
    both = tree.nodes.new("ShaderNodeAddShader")
    tree.links.new(body, both.inputs[0])
    tree.links.new(mirror.outputs[0], both.inputs[1])
    return both.outputs[0]


def surface(entry, around):
    material = bpy.data.materials.new("")
    tree, output = nodes_of(material, "ShaderNodeOutputMaterial")
    transparent = any(entry["taught"].get("transmission", []))
    plug(tree, output.inputs["Surface"], glass(tree, entry["taught"], around) if transparent else opaque(tree, entry))
    return material


def glowing(lamp):
    """Radiance on the front alone, which is black otherwise."""
    material = bpy.data.materials.new("lamp")
    tree, output = nodes_of(material, "ShaderNodeOutputMaterial")
    back = add(tree, "ShaderNodeNewGeometry").outputs["Backfacing"]
    strength = math_node(tree, "MULTIPLY_ADD", back, -lamp["intensity"], lamp["intensity"])
    plug(tree, output.inputs["Surface"], add(tree, "ShaderNodeEmission", Color=lamp["color"], Strength=strength).outputs[0])
    return material


def point_lamp(light):
    """Without size. A taught lamp of colour c gives a normal irradiance of pi c at any distance; a lamp of Cycles
    with a power of 4 pi W and constant falloff, of 1."""
    assert not light["extras"]["eyeray"]["falloff"], "only lamps without falloff are known"
    lamp = bpy.data.lights.new("lamp", "POINT")
    lamp.shadow_soft_size = 0
    lamp.color = light["color"]
    lamp.energy = 4 * math.pi * math.pi * light["intensity"]
    tree, output = nodes_of(lamp, "ShaderNodeOutputLight")
    falloff = add(tree, "ShaderNodeLightFalloff", Strength=1.0)
    plug(tree, output.inputs["Surface"], add(tree, "ShaderNodeEmission", Strength=falloff.outputs["Constant"]).outputs[0])
    return lamp


def sky(world, colors):
    """Horizon, mixed with sqrt |y| towards zenith or nadir."""
    tree, output = nodes_of(world, "ShaderNodeOutputWorld")
    black = [0, 0, 0]
    direction = add(tree, "ShaderNodeTexCoord").outputs["Generated"]
    y = add(tree, "ShaderNodeSeparateXYZ", Vector=direction).outputs["Y"]
    share = math_node(tree, "SQRT", math_node(tree, "ABSOLUTE", y))
    above = math_node(tree, "GREATER_THAN", y, 0.0)
    half = lambda fac, a, b: add(tree, "ShaderNodeMixRGB", Fac=fac, Color1=a, Color2=b).outputs[0]
    end = half(above, colors.get("nadir", black), colors.get("zenith", black))
    color = half(share, colors.get("horizon", black), end)
    plug(tree, output.inputs["Surface"], add(tree, "ShaderNodeBackground", Color=color).outputs[0])
