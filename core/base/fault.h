#pragma once
// Mistakes that every renderer has had at some time, kept to be shown: all are off unless a person asks for
// them.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace eyeray {

enum class Fault : std::uint8_t {
    SphereSlide,
    MollerTrumbore,
    SlabNan,
    GlobalEpsilon,
    FloatWorld,
    ObjectRayNormalised,
    NormalsByMatrix,
    SolidChecker,
    DegreesAsRadians,
    HorizontalFov,
    CornerSampling,
    CentreSampling,
    FlippedRows,
    ShadowNoTmax,
    AbsCosine,
    AmbientPerLight,
    ReflectionSign,
    EtaNotFlipped,
    SchlickInnerCosine,
    NanRefraction,
    HardTerminator,
    EarlyClamp,
    RouletteUnweighted,
    BadSeeding,
    EightBit,
    NoGamma
};

struct FaultName {
    std::string_view name;  // as in commands and on the command line
    std::string_view wrong; // one line: what the code does, and what it should do
};

/// By Fault.
inline constexpr std::array kFaultNames = {
    FaultName{"sphere-slide", "sphere by b^2 - 4ac, which cancels far away; by the ray's distance instead"},
    FaultName{"moller-trumbore",
              "u and v for each triangle apart, |det| < 1e-6 a miss: gaps at edges, holes"},
    FaultName{"slab-nan", "box test without a thought to 0 * inf: rays in the plane of a face miss"},
    FaultName{"global-epsilon", "rays start at o + t d and skip a fixed epsilon, whatever the scene's scale"},
    FaultName{"float-world", "world coordinates in float from the file's origin, however far that is"},
    FaultName{"object-ray-normalised", "ray made unit in object space, its t then taken as the world's"},
    FaultName{"normals-by-m", "normals by M as if they were points; they need its inverse transpose"},
    FaultName{"solid-checker", "checker by floor(x) + floor(y) + floor(z) on a plane where y rounds"},
    FaultName{"degrees-as-radians", "tan takes the field of view in degrees for radians"},
    FaultName{"horizontal-fov", "the vertical field of view used as the horizontal one"},
    FaultName{"corner-sampling", "rays through pixel corners: half a pixel to the left and up"},
    FaultName{"centre-sampling",
              "every sample through its pixel's centre: steps and moiré however many there are"},
    FaultName{"flipped-rows", "row 0 taken for the bottom one: the picture stands on its head"},
    FaultName{"shadow-no-tmax", "shadow rays that do not end at the lamp: things behind it block it"},
    FaultName{"abs-cosine", "|n . l| in place of max(0, n . l): lamps light the back as well"},
    FaultName{"ambient-per-light", "ambient light added once for each lamp"},
    FaultName{"reflection-sign", "r = 2 (n . l) n + l in place of - l: too long and too flat"},
    FaultName{"eta-not-flipped", "the same ratio of indices on the way out as on the way in"},
    FaultName{"schlick-inner-cosine", "Schlick's formula with the cosine of the inner angle on the way out"},
    FaultName{"nan-refraction", "Snell's law without the test for total reflection: a negative root"},
    FaultName{"hard-terminator", "smooth normals, but facets shadow themselves: black steps at dusk"},
    FaultName{"early-clamp", "radiance cut off at 1 (clamp=1) at every hit, not once at the display"},
    FaultName{"roulette-unweighted", "roulette that forgets to divide survivors by their probability"},
    FaultName{"bad-seeding", "generator seeded by pixel number anew for each sample: streaks that stay"},
    FaultName{"eight-bit", "film of 8 bits: the running mean stops where a step rounds to 0"},
    FaultName{"no-gamma", "linear values shown as they are, without the sRGB curve: too dark"},
};
inline constexpr int kFaults = static_cast<int>(kFaultNames.size());

constexpr const FaultName& describe(Fault fault) { return kFaultNames[static_cast<std::size_t>(fault)]; }

class FaultSet {
public:
    constexpr FaultSet() = default;
    constexpr FaultSet(Fault fault) : bits_(bit(fault)) {}

    constexpr bool has(Fault fault) const { return (bits_ & bit(fault)) != 0; }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr void set(Fault fault, bool on) { bits_ = on ? bits_ | bit(fault) : bits_ & ~bit(fault); }

    friend constexpr bool operator==(FaultSet, FaultSet) = default;

private:
    static constexpr std::uint32_t bit(Fault fault) { return 1U << static_cast<unsigned>(fault); }
    std::uint32_t bits_ = 0;
};
static_assert(kFaults <= 32);

/// Names with commas between, or "none".
std::string toText(FaultSet);

/// Throws InputError, naming all faults, for a name that is none.
Fault faultNamed(std::string_view);
FaultSet faultsNamed(std::string_view commaSeparated);

}
