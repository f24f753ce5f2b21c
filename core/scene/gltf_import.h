#pragma once
// What the sections of an import share, and the sections: each reads one part of glTF into the Scene, in the
// order in which gltf_import.cpp calls them.

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/scene/gltf_document.h"
#include "core/scene/gltf_fields.h"
#include "core/scene/gltf_notes.h"
#include "core/scene/scene.h"

namespace eyeray {

/// Thrown when the user asked to stop; caught by importGltf.
struct ImportStopped {};

class GltfImport {
public:
    GltfImport(const GltfDocument& d, const GltfFiles& f, const std::stop_token& t, Scene& s, GltfNotes& n)
        : document(d), files(f), stop(t), scene(s), notes(n) {}

    const GltfDocument& document;
    const GltfFiles& files;
    const std::stop_token& stop;
    Scene& scene;
    GltfNotes& notes;

    /// Throws ImportStopped if the user asked for it.
    void poll() const;
    /// Counts meshes before memory is taken for them. Throws InputError, naming `where`, when they get too
    /// much.
    void reserve(std::size_t triangles, std::size_t bytes, const std::string& where);
    /// Adds an object. Throws InputError when there are too many.
    void add(Object);
    /// The material that glTF gives to what has none.
    int defaultMaterial();

private:
    std::size_t triangles_ = 0, meshBytes_ = 0;
    std::optional<int> defaultMaterial_;
};

/// One primitive of a mesh of the file.
struct MeshPart {
    int mesh;     // in Scene
    int material; // in Scene
};

/// A node of the shown scene. `transform` takes its own space to the scene's.
struct PlacedNode {
    int node;
    DMat4 transform;
};

/// A name fit for the screen: one line, not long; `fallback` where there is none.
std::string nameOr(const std::string& name, const std::string& fallback);

/// Shapes of KHR_implicit_shapes, by their index in the file; −1 for a kind that Eyeray does not have.
std::vector<int> importShapes(GltfImport&);

/// Fills Scene::materials with the file's, under the same indices, and the textures and images they use.
void importMaterials(GltfImport&);

/// Meshes by their index in the file; a primitive that shows nothing is left out.
std::vector<std::vector<MeshPart>> importMeshes(GltfImport&);

/// The nodes of the shown scene in the order of the file. Throws InputError for cycles and for nodes with two
/// parents.
std::vector<PlacedNode> placeNodes(const GltfDocument&, GltfNotes&);

/// Objects, lamps and cameras, in node order.
void importNodes(GltfImport&, const std::vector<int>& shapes,
                 const std::vector<std::vector<MeshPart>>& meshes);

/// The lamp of KHR_lights_punctual that a node names, or its area lamp in extras; none where it has none.
std::optional<Light> importPunctualLight(GltfImport&, int node);
std::optional<Light> importAreaLamp(GltfFields& nodeExtras);

/// The camera of a node; none for an orthographic one. Where the file does not say how far its target is, it
/// lies level with the middle of the scene.
std::optional<Camera> importCamera(GltfImport&, const PlacedNode&, std::optional<double> distance,
                                   const SceneBounds&);

/// Objects that Eyeray makes by rule, placed under `transform`.
void importGenerated(GltfImport&, GltfFields& rule, const Object& prototype);

/// What extras.eyeray of the shown scene says. True if it says what light there is besides lamps.
bool importSceneExtras(GltfImport&);

/// Adds what a picture cannot do without: a material, a camera, and light unless `litOnPurpose`.
void completeScene(GltfImport&, bool litOnPurpose);

/// The scene that is shown: the file's default one, else the first; none if it has no scenes.
const tinygltf::Scene* shownScene(const GltfDocument&);

}
