#pragma once
// What the user says: everything that a scene file holds and an editor changes. Tracing reads a World
// instead. Ids are indices into the vectors of Scene; big arrays are shared, so copying a Scene is cheap.

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mesh.h"
#include "core/geometry/shapes.h"
#include "core/image/pixels.h"
#include "core/scene/camera.h"
#include "core/scene/light.h"
#include "core/scene/material.h"

namespace eyeray {

/// A picture of a file: its pixels as stored (how they are coded depends on what they are used for) and the
/// bytes that they came from, for export.
struct Image {
    std::string name;
    std::shared_ptr<const ByteImage> pixels;
    std::shared_ptr<const std::vector<std::byte>> encoded; // PNG or JPEG
};

enum class Wrap : std::uint8_t { Repeat, Clamp, Mirror };

struct ImageTexture {
    int image = 0;
    Wrap wrapU = Wrap::Repeat, wrapV = Wrap::Repeat;
    bool nearest = false; // else bilinear
};

/// Checkerboard of unit cells in texture space; the cell at [0, 1)² is even.
struct CheckerTexture {
    Color even{1}, odd{0}; // linear
};

struct Texture {
    std::string name;
    std::variant<ImageTexture, CheckerTexture> source;
};

struct Mesh {
    std::string name;
    std::shared_ptr<const TriangleMesh> triangles;
};

struct MeshId {
    int index = 0;
};
struct ShapeId {
    int index = 0;
};

/// One placed shape or mesh.
struct Object {
    std::string name;
    std::variant<MeshId, ShapeId> geometry;
    int material = 0;
    DMat4 transform{1}; // object to scene
    bool visible = true;
};

/// What rays see that hit nothing: vertical gradient, in radiance. Background only, except for methods that
/// say otherwise.
struct Environment {
    Color zenith{0}, horizon{0}, nadir{0};

    /// Radiance from a unit direction: horizon at y = 0, mixed with √|y| towards zenith or nadir.
    Color radiance(const Vec3& direction) const;
    bool black() const { return isBlack(zenith) && isBlack(horizon) && isBlack(nadir); }
};

struct Scene {
    std::string name;         // of a built-in scene, else the file's stem
    std::string whatToLookAt; // one line for the class
    std::vector<Mesh> meshes;
    std::vector<Shape> shapes;
    std::vector<Image> images;
    std::vector<Texture> textures;
    std::vector<Material> materials; // never empty: importers add a default one
    std::vector<Object> objects;
    std::vector<Light> lights;
    std::vector<Camera> cameras; // never empty: importers add one that frames the scene
    Color ambient{0};            // Ia of the taught models
    Environment environment;
    std::vector<std::string>
        settings; // command lines that bring up the scene's own state, such as "set max-depth=8"
    bool statesExposure = false; // else a viewer meters it from the first picture
};

/// Box around all bounded objects, in scene coordinates; lo > hi where there are none.
struct SceneBounds {
    DVec3 lo{0}, hi{-1};
    bool empty() const { return !(lo.x <= hi.x); }
    DVec3 center() const { return 0.5 * (lo + hi); }
    double radius() const { return empty() ? 1.0 : 0.5 * glm::length(hi - lo); }
};
SceneBounds boundsOf(const Scene&);

/// Camera of the given name that frames the whole scene from the front, slightly above; fov 45°.
Camera framingCamera(const Scene&, std::string name);

/// Throws InternalError unless every id is in range and every number finite: what importers and edits
/// promise.
void validate(const Scene&);

}
