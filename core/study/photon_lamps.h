#pragma once
// The lamps as photons leave them: from where, whereto, and with how much power.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/base/sampling.h"
#include "core/scene/camera.h"
#include "core/scene/world.h"

namespace eyeray {

/// The random numbers of one photon, each addressed by where it is used.
class PhotonNumbers {
public:
    PhotonNumbers(std::uint32_t seed, std::uint64_t photon)
        : key_(hashCombine(hashCombine(seed, static_cast<std::uint32_t>(photon)),
                           static_cast<std::uint32_t>(photon >> 32U))) {}

    /// In [0, 1), of 53 bits: a lens far away is hit by few of the directions that a float could tell apart.
    double operator()(std::uint32_t place) const {
        const std::uint64_t high = hashCombine(key_, 2 * place), low = hashCombine(key_, 2 * place + 1);
        return static_cast<double>((high << 32U | low) >> 11U) * 0x1p-53;
    }
    /// The same as a float, never 1.
    float single(std::uint32_t place) const { return toUnitFloat(hashCombine(key_, 2 * place)); }

private:
    std::uint32_t key_;
};

struct EmittedPhoton {
    int light = -1; // id in Scene::lights
    Vec3 origin{0}; // relative to the World's origin
    Vec3 direction{0, 0, -1};
    Color power{0};          // W; its mean over all photons is the power of all lamps
    float reach = kInfinity; // metres: the range of its lamp
};

/// All lamps of a World, with their extent. A sun's photons come from a disc that covers the
/// bounded scene and the eye. A taught lamp without falloff has no power: in its place stands the lamp with
/// falloff that gives the middle of the scene the same light. The sky and glowing materials send nothing.
class PhotonLamps {
public:
    PhotonLamps(const World&, const Camera&);

    bool empty() const { return lamps_.empty(); }
    const Color& power() const { return power_; } // of all, W
    /// True if one without falloff is replaced.
    bool replaced() const { return replaced_; }

    /// The photon's lamp by power (as luminance), then its place and direction: places 0 to 4 of the numbers.
    /// To be called if there are lamps.
    EmittedPhoton emit(const PhotonNumbers&) const;

    struct Point {
        DVec3 position;
    };
    struct Spot {
        DVec3 position, axis;
        double cosInner, cosOuter;
    };
    struct Sun {
        DVec3 direction;
        double radius; // of the disc, metres
    };
    struct Rectangle {
        DVec3 center, edgeX, edgeY, normal; // it shines along the normal
    };
    struct Disc {
        DVec3 center, axisX, axisY, normal; // of radii as long as the axes
    };
    struct Ball {
        DVec3 center;
        double radius;
    };
    using Shape = std::variant<Point, Spot, Sun, Rectangle, Disc, Ball>;

private:
    struct Lamp {
        Shape shape;
        int light;
        Color power;   // of one of its photons
        double before; // chance of all lamps before this one
        float reach;
    };
    std::vector<Lamp> lamps_;
    Color power_{0};
    bool replaced_ = false;
};

}
