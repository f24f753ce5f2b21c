#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_accessors.h"
#include "core/scene/gltf_import.h"
#include "core/scene/gltf_primitive.h"

namespace eyeray {

namespace {

/// What makes two primitives the same mesh: they differ in no more than their material's colours.
using MeshKey = std::tuple<std::map<std::string, int>, int, int, bool>;

/// Rays must meet both sides of what light passes through, and of what the file says.
bool isDoubleSided(const GltfImport& context, const tinygltf::Primitive& primitive, int material) {
    const auto& source = context.document.model.materials;
    if (primitive.material >= 0 && source[primitive.material].doubleSided) return true;
    const MaterialModel& model = context.scene.materials[material].model;
    if (const auto* const taught = std::get_if<TaughtMaterial>(&model)) return !isBlack(taught->transmission);
    return std::get<GltfMaterial>(model).transmission > 0;
}

int materialOf(GltfImport& context, const tinygltf::Primitive& primitive, const std::string& where) {
    if (primitive.material < 0) return context.defaultMaterial();
    if (static_cast<std::size_t>(primitive.material) >= context.document.model.materials.size())
        throw InputError{where, fmt::format("material {} does not exist", primitive.material),
                         "export the file again"};
    return primitive.material;
}

void noteUnshown(GltfImport& context, const tinygltf::Primitive& primitive) {
    if (!primitive.targets.empty()) context.notes.ignoredOne("morph targets", "mesh primitive");
    if (primitive.attributes.contains("JOINTS_0")) context.notes.ignoredOne("skin weights", "mesh primitive");
    for (const auto& extension : primitive.extensions)
        context.notes.ignoredOne(printable(extension.first, limits::kNameBytes), "mesh primitive");
}

class MeshImport {
public:
    explicit MeshImport(GltfImport& context) : context_(context) {}

    std::vector<MeshPart> partsOf(std::size_t index) {
        const tinygltf::Mesh& source = context_.document.model.meshes[index];
        std::vector<MeshPart> parts;
        for (std::size_t i = 0; i < source.primitives.size(); ++i) {
            context_.poll();
            const auto& primitive = source.primitives[i];
            const std::string where =
                fmt::format("{}.primitives[{}]", context_.document.at("meshes", index), i);
            const int material = materialOf(context_, primitive, where);
            const bool doubleSided = isDoubleSided(context_, primitive, material);
            const auto mesh =
                meshOf(primitive, doubleSided, nameOr(source.name, fmt::format("mesh {}", index)), where);
            if (mesh) parts.push_back({*mesh, material});
        }
        return parts;
    }

private:
    std::optional<int> meshOf(const tinygltf::Primitive& primitive, bool doubleSided, const std::string& name,
                              const std::string& where) {
        const MeshKey key{primitive.attributes, primitive.indices, primitive.mode, doubleSided};
        if (const auto known = known_.find(key); known != known_.end()) return known->second;
        noteUnshown(context_, primitive);
        auto mesh = importPrimitive(context_, primitive, where);
        std::optional<int> result;
        if (mesh) {
            mesh->doubleSided = doubleSided;
            result = static_cast<int>(context_.scene.meshes.size());
            context_.scene.meshes.push_back({name, std::make_shared<const TriangleMesh>(std::move(*mesh))});
        }
        known_[key] = result;
        return result;
    }

    GltfImport& context_;
    std::map<MeshKey, std::optional<int>> known_;
};

}

std::vector<std::vector<MeshPart>> importMeshes(GltfImport& context) {
    MeshImport import(context);
    const std::size_t count = context.document.model.meshes.size();
    std::vector<std::vector<MeshPart>> result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i) result.push_back(import.partsOf(i));
    return result;
}

}
