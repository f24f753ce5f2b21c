#pragma once
// Tracing from the light: where a photon goes until it is absorbed, leaves the scene or enters the eye. Arvo
// 1986, "Backward Ray Tracing", traces so too; the lectures call it forward.

#include <memory>
#include <optional>
#include <vector>

#include "core/base/ray_kind.h"
#include "core/scene/physical_surface.h"
#include "core/study/photon_lamps.h"
#include "core/transport/trace_context.h"

namespace eyeray {

/// A thin lens at the eye that is focused on the camera's target. It takes what comes from before it.
struct Lens {
    Vec3 center{0}; // relative to the World's origin
    Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
    float radius = 0.01F, focus = 1; // metres
    Vec2 half{1};                    // half extents of the image plane at distance 1

    /// How far along the unit direction a ray enters the lens, or nothing.
    std::optional<float> entered(const Vec3& origin, const Vec3& direction) const;

    /// Where the picture takes in light that enters at a point along a direction: from −1 to 1, to the right
    /// and upwards; more is beside the picture.
    Vec2 onPicture(const Vec3& point, const Vec3& direction) const;
};
Lens lensOf(const Camera&, const DVec3& origin, double aspect, double radius);

enum class PhotonEnd : std::uint8_t { Absorbed, Escaped, Lens };

/// From one surface to the next.
struct PhotonStep {
    RayKind kind = RayKind::Shadow; // what sent it: Shadow for the lamp
    Vec3 from{0}, to{0}; // relative to the World's origin; of the last one that escapes: a point on its way
    Color power{0};      // W, where it ends
};

struct PhotonPath {
    EmittedPhoton emitted;
    std::vector<PhotonStep> steps; // at least one
    PhotonEnd end = PhotonEnd::Absorbed;
    Color absorbed{0}; // W that surfaces and media have taken on the way
};

/// One photon after the other. Thread-safe.
class PhotonWalk {
public:
    PhotonWalk(std::shared_ptr<const World>, const Camera&, const Lens&, std::uint32_t seed = 0);

    const PhotonLamps& lamps() const { return lamps_; }
    const Lens& lens() const { return lens_; }
    const World& world() const { return *world_; }

    /// Calls each(path) for the photons of these numbers, in order; each may keep no reference. At a surface
    /// one of its lobes sends the photon on, with the power that it leaves; below kRoulette of its first
    /// power it is absorbed, or goes on stronger, at random. False if `stop` came first. To be called if
    /// there are lamps.
    template <class Each>
    bool walk(std::uint64_t first, int count, const std::stop_token& stop, const Each& each) const {
        PhotonPath path; // one for all, so that its memory is taken once
        for (int i = 0; i < count; ++i) {
            if (stop.stop_requested()) return false;
            trace(first + static_cast<std::uint64_t>(i), path);
            each(path);
        }
        return true;
    }

    static constexpr float kRoulette = 0.1F;
    static constexpr int kMostSteps = 256; // then it is absorbed

private:
    void trace(std::uint64_t number, PhotonPath&) const;

    std::shared_ptr<const World> world_;
    PhotonLamps lamps_;
    Lens lens_;
    std::uint32_t seed_;
    std::vector<PhysicalSurface> surfaces_; // of the materials that do not vary
};

}
