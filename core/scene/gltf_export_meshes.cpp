#include <glm/common.hpp>
#include <tiny_gltf.h>

#include "core/scene/gltf_export.h"

namespace eyeray {

using nlohmann::json;

namespace {

template <class T>
int accessor(GltfExport& context, const std::vector<T>& values, int componentType, std::size_t count,
             const char* type) {
    return context.push("accessors", {{"bufferView", context.view(std::as_bytes(std::span(values)))},
                                      {"componentType", componentType},
                                      {"count", count},
                                      {"type", type}});
}

template <class T>
int vectors(GltfExport& context, const std::vector<T>& values, const char* type) {
    return accessor(context, values, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size(), type);
}

}

json exportPrimitive(GltfExport& context, const TriangleMesh& mesh) {
    const int positions = vectors(context, mesh.positions, "VEC3");
    Bounds bounds;
    for (const Vec3& p : mesh.positions) bounds.add(p);
    context.document["accessors"][positions]["min"] = toJson(bounds.lo);
    context.document["accessors"][positions]["max"] = toJson(bounds.hi);

    json attributes{{"POSITION", positions}};
    if (!mesh.normals.empty()) attributes["NORMAL"] = vectors(context, mesh.normals, "VEC3");
    for (std::size_t set = 0; set < mesh.uvs.size(); ++set)
        if (!mesh.uvs[set].empty())
            attributes["TEXCOORD_" + std::to_string(set)] = vectors(context, mesh.uvs[set], "VEC2");
    if (!mesh.colors.empty()) attributes["COLOR_0"] = vectors(context, mesh.colors, "VEC4");
    return {{"attributes", attributes},
            {"indices", accessor(context, mesh.triangles, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                                 3 * mesh.triangles.size(), "SCALAR")}};
}

}
