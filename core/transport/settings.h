#pragma once
// What a person chooses about tracing itself.

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/fault.h"
#include "core/base/sampling.h"

namespace eyeray {

/// local: what a rasteriser knows (no shadows). cast: eye and shadow rays (Appel 1968). whitted: and mirrors
/// and glass. distributed: soft shadows, rough mirrors and glass (Cook 1984). path: and light from everywhere
/// (Kajiya 1986).
enum class Method : std::uint8_t { Local, Cast, Whitted, Distributed, Path };
inline constexpr std::array<std::string_view, 5> kMethodNames = {"local", "cast", "whitted", "distributed",
                                                                 "path"};

/// Methods that keep to physics: materials as PhysicalSurface, lamps with their extent, the sky as a lamp, no
/// ambient light.
constexpr bool isPhysical(Method method) { return method == Method::Distributed || method == Method::Path; }

/// Methods whose pictures are traced by streams (streams.h), many rays at once; others take one by one.
constexpr bool isByStreams(Method method) { return !isPhysical(method); }

/// Weights at glass: exact Fresnel equations, or the material's kr and kt at every angle.
enum class FresnelMode : std::uint8_t { Exact, Constant };
inline constexpr std::array<std::string_view, 2> kFresnelModeNames = {"exact", "constant"};

/// What transparent objects do to shadow rays: nothing; filter them straight through by kt and e^(−σd); block
/// them.
enum class GlassShadows : std::uint8_t { OpaqueOnly, Straight, AllBlock };
inline constexpr std::array<std::string_view, 3> kGlassShadowNames = {"opaque", "straight", "all"};

/// What eye rays go through: a sample's place in its pixel, or, where a pixel is crossed by an edge of a
/// mesh, a place on the edge, where leaks are.
enum class Aim : std::uint8_t { Samples, Edges };
inline constexpr std::array<std::string_view, 2> kAimNames = {"samples", "edges"};

/// Of the textbook formulas that faults bring in.
enum class Precision : std::uint8_t { Float, Double };
inline constexpr std::array<std::string_view, 2> kPrecisionNames = {"float", "double"};

inline constexpr int kMaxDepth = 64;

struct TraceSettings {
    Method method = Method::Whitted;
    int maxDepth = 5;      // the eye ray has depth 0; deeper rays count 0. 0 to kMaxDepth
    float cutoff = 0.002F; // rays of a smaller weight in every channel are not traced. 0 to 1
    bool shadows = true, reflections = true, refractions = true, diffuse = true;
    FresnelMode fresnel = FresnelMode::Exact;
    GlassShadows glassShadows = GlassShadows::Straight;
    Sampler sampler = Sampler::Sobol; // of distributed and path, but for the place in the pixel

    FaultSet faults;       // empty: everything is done as well as is known
    float epsilon = 1e-4F; // metres or parts of a ray that Fault::GlobalEpsilon skips. 0 to 1
    float clamp = 1;       // radiance that Fault::EarlyClamp leaves of more. 0 to 10⁶
    Precision precision = Precision::Float;
    Aim aim = Aim::Samples;

    friend bool operator==(const TraceSettings&, const TraceSettings&) = default;
};

}
