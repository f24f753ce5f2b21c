#pragma once
// What a World looks like to OpenGL: its objects as triangles on the graphics card.

#include <map>
#include <memory>

#include "app/gl/texture.h"
#include "app/rayview/gpu_mesh.h"
#include "core/scene/world.h"

namespace eyeray {

/// What multiplies an object's colour.
struct ItemTexture {
    enum class Kind : std::uint8_t { None, Checker, Image } kind = Kind::None;
    Color even{1}, odd{1};                  // of a checkerboard
    std::shared_ptr<GlTexture> image;       // sRGB-coded
    Vec2 row0{1, 0}, row1{0, 1}, offset{0}; // uv' = (row0·uv, row1·uv) + offset
};

/// One object to draw.
struct SceneItem {
    int object = -1; // id in Scene::objects; −1: the surface of a lamp
    std::shared_ptr<const GpuMesh> mesh;
    DMat4 toWorld{1}; // relative to the World's origin
    Surface surface;
    float metallic = 0; // share of its highlight that has the colour of its texture
    ItemTexture texture;
    bool flat = false;      // triangles without normals
    bool oneSided = false;  // not seen from behind
    bool unbounded = false; // an infinite plane, cut off somewhere
};

/// Used by the thread of its OpenGL.
class SceneMeshes {
public:
    explicit SceneMeshes(const Gl& gl) : gl_(gl) {}

    /// Makes the items those of this World. What an earlier World had too is not copied again.
    void update(const std::shared_ptr<const World>&);

    const std::vector<SceneItem>& items() const { return items_; }
    const std::shared_ptr<const World>& world() const { return world_; }

    /// Triangles on the graphics card that have been copied so far, for tests: camera moves copy none.
    std::size_t copiedMeshes() const { return copied_; }

private:
    using ShapeKey = std::array<float, 5>;
    using MeshPtr = std::shared_ptr<const GpuMesh>;

    void addObject(const Object&, int id, int segments);
    void addLamp(const Light&);
    void place(SceneItem, const DMat4& transform);
    MeshPtr shapeMesh(const Shape&, int segments);
    MeshPtr triangleMesh(const std::shared_ptr<const TriangleMesh>&);
    ItemTexture textureOf(const MaterialModel&);
    std::shared_ptr<GlTexture> imageTexture(const ImageTexture&);

    const Gl& gl_;
    std::shared_ptr<const World> world_;
    std::vector<SceneItem> items_;
    std::map<std::shared_ptr<const TriangleMesh>, MeshPtr> triangleMeshes_;
    std::map<ShapeKey, MeshPtr> shapeMeshes_;
    std::map<std::shared_ptr<const ByteImage>, std::shared_ptr<GlTexture>> images_;
    std::size_t copied_ = 0;
};

}
