#include "core/scene/gltf_import.h"

#include <new>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/scene/geometry_notes.h"

namespace eyeray {

namespace {

Scene import(std::span<const std::byte> file, const std::string& where, const GltfFiles& files,
             ImportReport& report, const std::stop_token& stop) {
    try {
        GltfNotes notes(report);
        const GltfDocument document = parseDocument(file, where, files, notes);
        Scene scene;
        scene.name = std::filesystem::path(where).stem().string();
        GltfImport context(document, files, stop, scene, notes);
        context.poll();
        const bool litOnPurpose = importSceneExtras(context);
        const auto shapes = importShapes(context);
        importMaterials(context);
        const auto meshes = importMeshes(context);
        importNodes(context, shapes, meshes);
        completeScene(context, litOnPurpose);
        validate(scene);
        noteGeometry(scene, notes, stop);
        notes.finish();
        return scene;
    } catch (const ImportStopped&) {
        return {};
    } catch (const std::bad_alloc&) {
        throw Failure{where, "does not fit into memory", "close other programs, or open a smaller scene"};
    }
}

}

void GltfImport::poll() const {
    if (stop.stop_requested()) throw ImportStopped{};
}

void GltfImport::reserve(std::size_t triangles, std::size_t bytes, const std::string& where) {
    if (triangles > limits::kTriangles - triangles_)
        throw InputError{
            where,
            fmt::format("the scene has more than {} million triangles", limits::kTriangles / 1'000'000),
            "simplify or split it"};
    if (bytes > limits::kMeshBytes - meshBytes_)
        throw InputError{where, fmt::format("the meshes take more than {} MB", limits::kMeshBytes >> 20U),
                         "simplify or split the scene"};
    triangles_ += triangles;
    meshBytes_ += bytes;
}

void GltfImport::add(Object object) {
    if (scene.objects.size() >= limits::kObjects)
        throw InputError{document.where, fmt::format("has more than {} objects", limits::kObjects),
                         "split the scene"};
    scene.objects.push_back(std::move(object));
}

int GltfImport::defaultMaterial() {
    if (!defaultMaterial_) {
        defaultMaterial_ = static_cast<int>(scene.materials.size());
        scene.materials.push_back({"default", GltfMaterial{}});
    }
    return *defaultMaterial_;
}

std::string nameOr(const std::string& name, const std::string& fallback) {
    return printable(name.empty() ? fallback : name, limits::kNameBytes);
}

const tinygltf::Scene* shownScene(const GltfDocument& document) {
    const tinygltf::Model& model = document.model;
    const int shown = std::max(model.defaultScene, 0);
    if (static_cast<std::size_t>(shown) < model.scenes.size()) return &model.scenes[shown];
    if (model.defaultScene >= 0)
        throw InputError{document.where,
                         fmt::format("shows scene {}, there are {}", model.defaultScene, model.scenes.size()),
                         "export the file again"};
    return nullptr;
}

Scene importGltf(const std::filesystem::path& path, ImportReport& report, const std::stop_token& stop) {
    const auto file = readFile(path, limits::kFileBytes);
    return import(file, path.string(), GltfFiles(path.parent_path()), report, stop);
}

Scene importGltf(std::span<const std::byte> file, const std::string& where, ImportReport& report,
                 const std::stop_token& stop) {
    return import(file, where, GltfFiles(std::nullopt), report, stop);
}

}
