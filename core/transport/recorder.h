#pragma once
// Watching a sample being traced. Rendering uses NoRecorder, which costs nothing.

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/base/ray_kind.h"

namespace eyeray {

// In the place of an id in Scene::lights.
inline constexpr int kSkyLight = -1, kGlowingObjects = -2;

/// How a ray ended.
enum class RayEnd : std::uint8_t { Hit, Background, Unblocked, Blocked };

/// What a ray met, for those who watch.
struct HitRecord {
    int object = -1;                    // id in Scene::objects, −1 for the surface of a lamp
    int material = -1;                  // id in Scene::materials, −1 for the surface of a lamp
    std::uint32_t primitive = 0;        // triangle of a mesh; face of a shape
    Vec3 position{0};                   // relative to the World's origin
    Vec3 normal{0}, geometricNormal{0}; // unit, on the side that the ray came from
    bool front = true;                  // the surface's own side was hit
    Color emission{0}, ambient{0};      // radiance: Le, and ka Ia
    Color diffuseReflectance{0};        // kd
};

/// One ray of a sample's tree, in order of tracing: a parent comes before its children. Its radiance is
/// transmitted · (emission + ambient + its lamp terms in order + (reflection + refraction, each share ·
/// radiance)), in this order of float operations, or transmitted · background; of a shadow ray: 0.
struct RayRecord {
    int parent = -1;
    RayKind kind = RayKind::Eye;
    int depth = 0;                // a shadow ray has the depth of the ray whose hit cast it
    Vec3 origin{0}, direction{0}; // relative to the World's origin; the direction is unit
    float t = kInfinity;          // of the hit, or to the lamp
    int object = -1;              // hit: id in Scene::objects, −1 for none or the surface of a lamp
    int light = -1;               // of a shadow ray: id in Scene::lights, or as above
    int medium = -1;              // it runs in: id in Scene::objects, −1 for none
    Color share{1};               // of its radiance that its parent's hit sends on: kr or kt at this angle
    Color weight{1};              // of its radiance that reaches the pixel
    Color transmitted{1};         // what the medium on the way leaves; of a shadow ray: all that is between
    Color radiance{0};            // what it brings: of a shadow ray its lamp's unblocked share
    Color background{0};          // what it sees where it hits nothing
    HitRecord hit{};              // valid if `end` is Hit
    float foundMis = 1; // weight of multiple importance sampling within the hit's emission or the background
    RayEnd end = RayEnd::Background;
    bool totalReflection = false; // a reflection ray that carries all the light
    float eta = 1;                // of a refraction ray: η of the side it came from / η of its own
    float cosine = 0;             // of the angle of incidence at its parent's hit
};

/// What one lamp adds where a ray ends: (diffuse + specular) · irradiance / π · visibility.
struct LampTerm {
    enum class State : std::uint8_t { Lit, FacesAway, OutOfReach } state = State::Lit; // others are black
    int ray = -1;                                                                      // at whose hit
    int light = -1;                        // id in Scene::lights, or as above
    int shadowRay = -1;                    // −1: none was traced
    Vec3 wi{0};                            // unit, towards the lamp
    Color diffuse{0}, specular{0};         // kd (n·l); ks (r·v)^n or ks (n·h)^n
    float diffuseMis = 1, specularMis = 1; // weights of multiple importance sampling within these
    Color irradiance{0};                   // over π, at normal incidence: the lectures' colour of a lamp
    float pdfW = 0; // with which wi was taken among those towards the lamp; 0: there is but one
    Color visibility{1}, radiance{0};
};

/// A reflection or refraction that was not traced.
struct UntracedRay {
    enum class Reason : std::uint8_t {
        SwitchedOff,
        DepthLimit,
        Cutoff,
        TreeLimit,
        Roulette
    } reason = Reason::SwitchedOff;
    int parent = -1;
    RayKind kind = RayKind::Reflection;
    Vec3 direction{0};
    Color share{0}, weight{0};
};

/// All that happened in one sample.
struct SampleRecord {
    std::vector<RayRecord> rays; // the eye ray first; none if nothing was traced
    std::vector<LampTerm> lamps; // in order of shading
    std::vector<UntracedRay> untraced;
    bool physical = false; // of a method whose lamp terms and shares are f cos, weighed, and f cos / pdf
};

struct NoRecorder {
    static constexpr bool kOn = false;
};

struct TreeRecorder {
    static constexpr bool kOn = true;
    SampleRecord record;

    /// Returns the ray's index.
    int add(const RayRecord& ray) {
        record.rays.push_back(ray);
        return static_cast<int>(record.rays.size()) - 1;
    }
    void clear() {
        record.rays.clear();
        record.lamps.clear();
        record.untraced.clear();
        record.physical = false;
    }
    RayRecord& at(int ray) { return record.rays[static_cast<std::size_t>(ray)]; }
};

}
