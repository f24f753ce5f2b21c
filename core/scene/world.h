#pragma once
// What tracing needs, prepared from a Scene: immutable and shared, so an edit never races with a ray.

#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/geometry/accel.h"
#include "core/scene/needs.h"
#include "core/scene/physical_surface.h"
#include "core/scene/scene.h"
#include "core/scene/surface.h"

namespace eyeray {

enum class AccelKind : std::uint8_t { Auto, Brute, Bvh2, Bvh8 };
inline constexpr std::array<std::string_view, 4> kAccelNames = {"auto", "brute", "bvh2", "bvh8"};

struct BuildSettings {
    AccelKind accel = AccelKind::Auto; // Auto: by choose_index.h
    bool byStreams = true;             // for Auto: many rays come at once, else one after the other
    friend bool operator==(const BuildSettings&, const BuildSettings&) = default;
};

/// A material ready for tracing: its surface, and what has to be read anew at each point, if anything.
struct WorldMaterial {
    Surface surface;
    PhysicalSurface physical; // the same for the methods that keep to physics
    bool varies = false;      // read textures: then `model` is evaluated at each hit
    bool transmits = false;   // anywhere
    MaterialModel model;
};

/// What the tracer must know of an instance of the accelerator.
struct WorldObject {
    std::uint32_t material = 0;
    int sceneObject = -1;   // id in Scene::objects; -1: the surface of a lamp
    int sceneLight = -1;    // of the surface of a lamp: id in Scene::lights
    bool solid = false;     // has an inside: rays that pass its surface change medium
    std::uint32_t rank = 0; // of transparent solids: where several overlap, the highest is what is there
    bool vertexColors = false;
};

/// A lamp as one point, or as a direction.
struct WorldLight {
    enum class Kind : std::uint8_t {
        Point,
        Directional,
        Spot,
        Facing
    } kind = Kind::Point; // Facing: cosine at the lamp
    Vec3 position{0};
    Vec3 direction{0, 0, -1}; // where it shines, unit
    Color emission{0};        // radiant intensity, or normal irradiance where distance does not count
    bool falloff = true;      // inverse square
    float cosInner = 1, cosOuter = 0;
    float range = kInfinity;
    int sceneLight = 0;
    bool followsCamera = false; // position and direction are then in camera axes
};

struct World {
    std::shared_ptr<const Scene> scene; // textures are read from here
    std::shared_ptr<const Accel> accel;
    DVec3 origin{0};                  // every float of a World is relative to it
    float radius = 1;                 // of the bounded objects
    std::vector<WorldObject> objects; // by instance of the accelerator
    std::vector<WorldMaterial> materials;
    std::vector<WorldLight> lights;
    SceneNeeds needs;

    AccelKind accelKind = AccelKind::Bvh8;            // which one Auto has become
    std::size_t primitives = 0, nodes = 0, bytes = 0; // of the accelerator
    bool refitted = false;   // its tree is that of a World before: the same hits by way of other nodes
    double buildSeconds = 0; // what it took to prepare all this
};

/// Prepares a scene for tracing. Shares with `previous` the indices over meshes that it has, and all of its
/// accelerator if no surface is another or elsewhere; nothing of the World else depends on it. Returns
/// nothing if `stop` was requested.
std::shared_ptr<const World> buildWorld(const std::shared_ptr<const Scene>&, const BuildSettings&,
                                        const World* previous = nullptr, const std::stop_token& stop = {});

/// The same pictures sooner where objects have moved since `previous`: its tree may stay, with other boxes.
/// Then what rays visit on their way depends on where objects were before.
std::shared_ptr<const World> refitWorld(const std::shared_ptr<const Scene>&, const BuildSettings&,
                                        const World& previous, const std::stop_token& stop = {});

/// The surface of a varying material at a hit: textures and vertex colour read. `uv(set)` gives texture
/// coordinates.
template <class Uv>
Surface surfaceAt(const World&, const WorldMaterial&, const Uv& uv, const Color& vertexColor);
template <class Uv>
PhysicalSurface physicalAt(const World&, const WorldMaterial&, const Uv& uv, const Color& vertexColor);

}

#include "core/scene/world_surface.h"
