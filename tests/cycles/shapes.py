# Shapes of KHR_implicit_shapes as meshes of Blender.
import bmesh
import bpy

SPHERE_SUBDIVISIONS = 7  # 81,920 triangles: Cycles has no sphere whose inside can be seen


def polygons(corners, faces):
    result = bpy.data.meshes.new("")
    result.from_pydata(corners, [], faces)
    return result


def plane(size):
    x, z = size["sizeX"] / 2, size["sizeZ"] / 2
    return polygons([(-x, 0, -z), (-x, 0, z), (x, 0, z), (x, 0, -z)], [(0, 1, 2, 3)])


def box(size):
    x, y, z = (side / 2 for side in size["size"])
    corners = [(i * x, j * y, k * z) for i in (-1, 1) for j in (-1, 1) for k in (-1, 1)]
    return polygons(corners, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def sphere(size):
    result = bpy.data.meshes.new("")
    facets = bmesh.new()
    bmesh.ops.create_icosphere(facets, subdivisions=SPHERE_SUBDIVISIONS, radius=size["radius"])
    facets.to_mesh(result)
    facets.free()
    result.polygons.foreach_set("use_smooth", [True] * len(result.polygons))
    return result


def mesh(entry):
    return {"plane": plane, "box": box, "sphere": sphere}[entry["type"]](entry[entry["type"]])


def lamp(entry):
    x, y = entry["width"] / 2, entry["height"] / 2
    return polygons([(-x, -y, 0), (-x, y, 0), (x, y, 0), (x, -y, 0)], [(0, 1, 2, 3)])  # it shines to its -z
