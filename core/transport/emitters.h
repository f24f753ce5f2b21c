#pragma once
// Lamps as the physical methods see them: with their extent, to be sampled by solid angle; and the sky.

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "core/scene/world.h"
#include "core/transport/emitter_shapes.h"
#include "core/transport/glowing_objects.h"
#include "core/transport/lights.h"
#include "core/transport/recorder.h"

namespace eyeray {

/// Where light comes from at a point, drawn at random where a lamp has an extent.
struct EmitterSample {
    Vec3 wi{0};          // unit, from the point to the lamp
    float distance = 0;  // infinite for a directional lamp and the sky
    Color irradiance{0}; // at normal incidence, unoccluded: radiance / pdfW of a lamp with an extent
    float pdfW = 0;      // 0: a ray that leaves the point at random cannot find the lamp
};

/// A lamp of the scene, the sky, or all objects that glow. Lamps that follow the camera or end at a range,
/// and taught lamps without falloff, keep their extent for soft shadows, but rays cannot find them: they are
/// only sampled.
struct Emitter {
    std::variant<std::monostate, SphericalRectangle, SphericalDisc, SphericalEllipsoid, SkyGradient,
                 std::shared_ptr<const GlowingObjects>>
        shape;             // else a point
    WorldLight light;      // as one point; of the sky and what glows only its id
    Color radiance{0};     // of its surface
    bool findable = false; // by rays that are sent at random
};

/// How `position`, on an instance of the World, sees the emitter at u in [0, 1)², or nothing where it does
/// not shine.
std::optional<EmitterSample> sampleEmitter(const Emitter&, const Vec3& position, std::uint32_t instance,
                                           const Vec2& u);

/// Density with which sampleEmitter gives wi, which is known to hit the emitter; 0 if it is not findable. Of
/// objects that glow it is GlowingObjects::pdfW.
float emitterPdfW(const Emitter&, const Vec3& position, const Vec3& wi);

/// All lamps of a picture, in the order of lightsFor, then the sky if it is not black, then what glows, if
/// asked for.
struct Emitters {
    std::vector<Emitter> all;
    std::vector<int> ofLight; // by id in Scene::lights; −1: none
    int sky = -1;
    std::shared_ptr<const GlowingObjects> glowing; // null: none, or not asked for
    bool findable = false; // a ray sent at random can come upon light: an emitter or an object that glows

    Emitters() = default;
    Emitters(const World&, const Camera&, bool withGlowing);
};

}
