#pragma once
// What the parts of an export share. One file per part; gltf_export.cpp calls them in order.

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/scene/scene.h"

namespace eyeray {

/// A glTF document that grows: its JSON, and one buffer that everything binary goes into.
class GltfExport {
public:
    explicit GltfExport(const Scene& s);

    const Scene& scene;
    nlohmann::json document;
    std::vector<std::byte> buffer;

    /// The finished document but for its buffers.
    nlohmann::json finished() const;
    /// Appends an entry to a section; its index.
    int push(const char* section, nlohmann::json entry);
    /// Appends bytes to the buffer, aligned to 4; the index of their view.
    int view(std::span<const std::byte> bytes);
    /// Notes that the document uses an extension; its name, for use as a key.
    const char* use(const char* extension);

    /// The index of a material for geometry that is seen from one side or from both. In glTF this belongs to
    /// the material, so one that is used both ways is written twice.
    int materialFor(int material, bool doubleSided);

private:
    struct Sides {
        bool known = false, both = false; // how the entry under the Scene's index is seen
        int other = -1;                   // entry that is seen the other way; −1 not written
    };
    std::set<std::string> extensions_;
    std::vector<Sides> sides_;
};

/// Numbers as JSON: a float by the fewest digits that read back as the same float.
nlohmann::json toJson(float);
nlohmann::json toJson(const Vec2&);
nlohmann::json toJson(const Color&);

/// Writes all images and image textures; texture indices of Scene to those of the file, −1 for a
/// checkerboard.
std::vector<int> exportTextures(GltfExport&);

/// Writes all materials under the indices they have in the Scene.
void exportMaterials(GltfExport&, const std::vector<int>& textures);

/// Writes all objects, lamps and cameras as nodes of the one scene, and the meshes and shapes they use.
void exportNodes(GltfExport&);

/// Writes the triangles of a mesh of the Scene: a glTF primitive without a material.
nlohmann::json exportPrimitive(GltfExport&, const TriangleMesh&);

}
