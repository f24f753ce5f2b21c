#pragma once
// Where light goes on at a mirror or at glass.

#include <optional>

#include "core/transport/faults.h"
#include "core/transport/shading_point.h"
#include "core/transport/trace_context.h"

namespace eyeray {

/// The rays that a hit sends on, with the share of the radiance that each brings.
struct NextRays {
    Vec3 reflection{0}, refraction{0}; // unit; valid where the share is not black
    Color reflectedShare{0}, refractedShare{0};
    MediumStack refractedMedia;
    bool totalReflection = false;
    float eta = 1; // of wo's side / of the other side
};

/// A surface, met from one of its sides.
struct Side {
    std::uint32_t instance;
    bool solid, front;
    float ior;
};

/// What is on both sides of a surface.
struct Interface {
    float eta; // of wo's side / of the other side
    MediumStack beyond;
};

/// The media at a hit, by the side that was hit; a surface without inside (a plane) has no medium beyond.
Interface interfaceAt(const World&, const Side&, const MediumStack&);
Interface interfaceAt(const World&, const ShadingPoint&, const MediumStack&);

/// Mirror and refraction directions and their shares. η is that of the media on both sides, by the side that
/// was hit; a surface without inside (a plane) is a thin pane that bends nothing. Reflections stay on the
/// geometric side of wo.
template <class Faults = NoFaults>
NextRays nextRays(const World&, const TraceSettings&, const ShadingPoint&, const MediumStack&,
                  Faults faults = {});

}
