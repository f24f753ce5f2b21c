#include <algorithm>
#include <map>

#include "core/scene/gltf_export.h"
#include "core/scene/gltf_units.h"

namespace eyeray {

using nlohmann::json;

namespace {

json matrixJson(const DMat4& m) {
    json result = json::array();
    for (int i = 0; i < 16; ++i) result.push_back(m[i / 4][i % 4]);
    return result;
}

json shapeJson(const Sphere& sphere) {
    return {{"type", "sphere"}, {"sphere", {{"radius", toJson(sphere.radius)}}}};
}
json shapeJson(const Box& box) { return {{"type", "box"}, {"box", {{"size", toJson(box.size)}}}}; }
json shapeJson(const Cylinder& cylinder) {
    return {{"type", "cylinder"},
            {"cylinder",
             {{"height", toJson(cylinder.height)},
              {"radiusTop", toJson(cylinder.radiusTop)},
              {"radiusBottom", toJson(cylinder.radiusBottom)}}}};
}
json shapeJson(const Plane& plane) {
    json result{{"type", "plane"}, {"plane", {{"doubleSided", plane.doubleSided}}}};
    if (plane.sizeX < kInfinity) result["plane"]["sizeX"] = toJson(plane.sizeX);
    if (plane.sizeZ < kInfinity) result["plane"]["sizeZ"] = toJson(plane.sizeZ);
    return result;
}

class NodeExport {
public:
    explicit NodeExport(GltfExport& context) : context_(context), scene_(context.scene) {}

    void run() {
        exportShapes();
        exportMeshes();
        for (const Object& object : scene_.objects) place(objectNode(object), object.name, object.transform);
        for (const Light& light : scene_.lights) place(lightNode(light), light.name, light.transform);
        for (const Camera& camera : scene_.cameras) exportCamera(camera);
        context_.push("scenes", {{"nodes", roots_}, {"extras", {{"eyeray", sceneExtras()}}}});
    }

private:
    void place(json node, const std::string& name, const DMat4& transform) {
        node["name"] = name;
        if (transform != DMat4(1)) node["matrix"] = matrixJson(transform);
        roots_.push_back(context_.push("nodes", std::move(node)));
    }

    json& extensionList(const char* extension, const char* list) {
        return context_.document["extensions"][context_.use(extension)][list];
    }

    void exportShapes() {
        for (const Shape& shape : scene_.shapes)
            extensionList("KHR_implicit_shapes", "shapes")
                .push_back(std::visit([](const auto& s) { return shapeJson(s); }, shape));
    }

    /// In glTF a mesh has its material, so one that is used with several is written once for each; the
    /// triangles are shared.
    void exportMeshes() {
        std::vector<std::vector<int>> materials(scene_.meshes.size());
        for (const Object& object : scene_.objects)
            if (const auto* const mesh = std::get_if<MeshId>(&object.geometry))
                if (auto& used = materials[mesh->index];
                    std::find(used.begin(), used.end(), object.material) == used.end())
                    used.push_back(object.material);
        for (std::size_t i = 0; i < materials.size(); ++i) {
            if (materials[i].empty()) continue;
            const TriangleMesh& triangles = *scene_.meshes[i].triangles;
            json primitive = exportPrimitive(context_, triangles);
            for (const int material : materials[i]) {
                primitive["material"] = context_.materialFor(material, triangles.doubleSided);
                meshes_[{static_cast<int>(i), material}] = context_.push(
                    "meshes", {{"name", scene_.meshes[i].name}, {"primitives", json::array({primitive})}});
            }
        }
    }

    json objectNode(const Object& object) const {
        json node;
        json extras;
        if (const auto* const mesh = std::get_if<MeshId>(&object.geometry)) {
            node["mesh"] = meshes_.at({mesh->index, object.material});
        } else {
            extras["shape"] = std::get<ShapeId>(object.geometry).index;
            extras["material"] = object.material;
        }
        if (!object.visible) extras["visible"] = false;
        if (!extras.is_null()) node["extras"]["eyeray"] = std::move(extras);
        return node;
    }

    json lightNode(const Light& light) {
        json node;
        const json flags = lightFlags(light);
        if (const auto* const rectangle = std::get_if<RectangleLamp>(&light.shape)) {
            node["extras"]["eyeray"]["lamp"] = lampJson(light, flags, "rectangle");
            node["extras"]["eyeray"]["lamp"].update(
                {{"width", rectangle->width}, {"height", rectangle->height}});
        } else if (const auto* const disc = std::get_if<DiscLamp>(&light.shape)) {
            node["extras"]["eyeray"]["lamp"] = lampJson(light, flags, "disc");
            node["extras"]["eyeray"]["lamp"]["radius"] = disc->radius;
        } else if (const auto* const sphere = std::get_if<SphereLamp>(&light.shape)) {
            node["extras"]["eyeray"]["lamp"] = lampJson(light, flags, "sphere");
            node["extras"]["eyeray"]["lamp"]["radius"] = sphere->radius;
        } else {
            json& lights = extensionList("KHR_lights_punctual", "lights");
            lights.push_back(punctualJson(light, flags));
            node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
        }
        return node;
    }

    /// What differs from a lamp as glTF knows it.
    static json lightFlags(const Light& light) {
        json flags = json::object();
        if (!light.falloff) flags["falloff"] = false;
        if (!light.enabled) flags["enabled"] = false;
        if (light.followsCamera) flags["followsCamera"] = true;
        return flags;
    }

    static json lampJson(const Light& light, const json& flags, const char* type) {
        json lamp{{"type", type}, {"color", toJson(light.color)}, {"intensity", light.intensity}};
        if (std::isfinite(light.range)) lamp["range"] = light.range;
        lamp.update(flags);
        return lamp;
    }

    static json punctualJson(const Light& light, const json& flags) {
        json result{{"name", light.name},
                    {"type", std::holds_alternative<DirectionalLamp>(light.shape) ? "directional" : "point"},
                    {"color", toJson(light.color)},
                    {"intensity", light.falloff ? light.intensity * kLumensPerWatt : light.intensity}};
        if (const auto* const spot = std::get_if<SpotLamp>(&light.shape)) {
            result["type"] = "spot";
            result["spot"] = {{"innerConeAngle", spot->innerCone}, {"outerConeAngle", spot->outerCone}};
        }
        if (std::isfinite(light.range)) result["range"] = light.range;
        if (!flags.empty()) result["extras"]["eyeray"] = flags;
        return result;
    }

    void exportCamera(const Camera& camera) {
        const CameraAxes axes = axesOf(camera);
        const double distance = camera.distance();
        json perspective{{"yfov", camera.verticalFov}, {"znear", std::max(1e-3 * distance, 1e-9)}};
        if (camera.aspect > 0) perspective["aspectRatio"] = camera.aspect;
        const int index = context_.push(
            "cameras", {{"name", camera.name}, {"type", "perspective"}, {"perspective", perspective}});
        json node{{"camera", index}};
        if (distance > 0) node["extras"]["eyeray"]["distance"] = distance;
        if (camera.lensRadius > 0)
            node["extras"]["eyeray"]["lens"] = {{"radius", camera.lensRadius},
                                                {"focus", camera.focusDistance}};
        place(std::move(node), camera.name,
              DMat4(DVec4(axes.right, 0), DVec4(axes.up, 0), DVec4(axes.backward, 0), DVec4(camera.eye, 1)));
    }

    json sceneExtras() const {
        const Environment& sky = scene_.environment;
        json extras{{"version", 1},
                    {"ambient", toJson(scene_.ambient)},
                    {"environment",
                     {{"zenith", toJson(sky.zenith)},
                      {"horizon", toJson(sky.horizon)},
                      {"nadir", toJson(sky.nadir)}}}};
        if (!scene_.whatToLookAt.empty()) extras["lookAt"] = scene_.whatToLookAt;
        if (!scene_.settings.empty()) extras["settings"] = scene_.settings;
        return extras;
    }

    GltfExport& context_;
    const Scene& scene_;
    std::map<std::pair<int, int>, int> meshes_; // (mesh, material) of the Scene to the file's mesh
    std::vector<int> roots_;
};

}

void exportNodes(GltfExport& context) { NodeExport(context).run(); }

}
