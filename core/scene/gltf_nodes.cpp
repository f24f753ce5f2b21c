#include <algorithm>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_import.h"

namespace eyeray {

namespace {

/// A camera can be placed only when all objects are known.
struct CameraNode {
    PlacedNode placed;
    std::optional<double> distance;
    double lensRadius = 0, focusDistance = 0;
};

/// Rays are taken into the space of an object by the inverse of its transform, which must not lose numbers.
bool invertible(const DMat4& m) {
    constexpr double kSmallest = 1e-15, kFlattest = 1e-12;
    const DVec3 x(m[0]), y(m[1]), z(m[2]);
    const double sizes = glm::length(x) * glm::length(y) * glm::length(z);
    const double shortest = std::min({glm::length(x), glm::length(y), glm::length(z)});
    return shortest > kSmallest && std::fabs(glm::dot(x, glm::cross(y, z))) > kFlattest * sizes;
}

void importMesh(GltfImport& context, int mesh, const Object& prototype,
                const std::vector<std::vector<MeshPart>>& meshes, const std::string& where) {
    if (static_cast<std::size_t>(mesh) >= meshes.size())
        throw InputError{where, fmt::format("mesh {} does not exist", mesh), "export the file again"};
    for (const MeshPart& part : meshes[mesh]) {
        context.poll();
        Object object = prototype;
        object.geometry = MeshId{part.mesh};
        object.material = part.material;
        if (meshes[mesh].size() > 1) object.name += fmt::format(" [{}]", &part - meshes[mesh].data());
        context.add(std::move(object));
    }
}

/// The objects of a node. What glTF cannot say comes first: a mesh beside it is for other programs.
void importObjects(GltfImport& context, const PlacedNode& placed, GltfFields& extras,
                   const std::vector<int>& shapes, const std::vector<std::vector<MeshPart>>& meshes) {
    const tinygltf::Node& node = context.document.model.nodes[placed.node];
    Object object;
    object.name = nameOr(node.name, fmt::format("node {}", placed.node));
    object.transform = placed.transform;
    object.visible = extras.flag("visible", true);
    const auto shape = extras.index("shape", shapes.size());
    const auto material = extras.index("material", context.scene.materials.size());
    const int shown = shape ? shapes[*shape] : -1;
    GltfFields rule = extras.child("generate");
    if (shape || rule.present()) object.material = material ? *material : context.defaultMaterial();

    if (rule.present()) {
        importGenerated(context, rule, object);
    } else if (shown >= 0) {
        object.geometry = ShapeId{shown};
        context.add(std::move(object));
    } else if (node.mesh >= 0) {
        importMesh(context, node.mesh, object, meshes, extras.where());
    }
}

void importLights(GltfImport& context, const PlacedNode& placed, GltfFields& extras) {
    const std::string& nodeName = context.document.model.nodes[placed.node].name;
    for (auto& light : {importPunctualLight(context, placed.node), importAreaLamp(extras)}) {
        if (!light) continue;
        Light lamp = *light;
        lamp.name = nameOr(nodeName, nameOr(lamp.name, fmt::format("lamp {}", placed.node)));
        lamp.transform = placed.transform;
        context.scene.lights.push_back(std::move(lamp));
    }
}

}

void importNodes(GltfImport& context, const std::vector<int>& shapes,
                 const std::vector<std::vector<MeshPart>>& meshes) {
    const auto& model = context.document.model;
    std::vector<CameraNode> cameras;
    for (const PlacedNode& placed : placeNodes(context.document, context.notes)) {
        context.poll();
        const tinygltf::Node& node = model.nodes[placed.node];
        const std::string where = context.document.at("nodes", static_cast<std::size_t>(placed.node));
        if (node.camera >= 0 && static_cast<std::size_t>(node.camera) >= model.cameras.size())
            throw InputError{where, fmt::format("camera {} does not exist", node.camera),
                             "export the file again"};
        if (!invertible(placed.transform)) {
            context.notes.repaired(where + ": its scale makes it flat, it is left out");
            continue;
        }
        GltfFields extras = eyerayExtras(node.extras, where, context.notes);
        importObjects(context, placed, extras, shapes, meshes);
        importLights(context, placed, extras);
        std::optional<double> distance;
        if (extras.has("distance")) distance = extras.number("distance", 1, kPositive);
        GltfFields lens = extras.child("lens");
        if (node.camera >= 0)
            cameras.push_back({placed, distance, lens.number("radius", 0, kNotNegative),
                               lens.number("focus", 0, kNotNegative)});
        lens.reportUnread();
        extras.reportUnread();
    }

    const SceneBounds bounds = boundsOf(context.scene);
    for (const auto& [placed, distance, lensRadius, focusDistance] : cameras)
        if (auto camera = importCamera(context, placed, distance, bounds)) {
            camera->lensRadius = lensRadius;
            camera->focusDistance = focusDistance;
            context.scene.cameras.push_back(*camera);
        }
}

}
