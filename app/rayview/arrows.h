#pragma once
// The rays of traced samples as arrows in space.

#include <vector>

#include "core/scene/world.h"
#include "core/transport/recorder.h"

namespace eyeray {

/// One ray, from where it starts to where it ends, relative to the World's origin.
struct Arrow {
    int sample = 0; // which of the samples shown
    int ray = 0;    // index in its SampleRecord
    RayKind kind = RayKind::Eye;
    RayEnd end = RayEnd::Hit;
    bool endless = false; // it goes on beyond `to`: the background, or a lamp infinitely far
    Vec3 from{0}, to{0};
    Vec3 blocker{0};  // where a blocked ray is blocked
    float weight = 1; // largest component of its share of the pixel
    float opacity = 1;
};

/// The arrows of a record, in its order. Vertices are the record's own; rays that never end are drawn
/// `reach` metres long. The blocker of a shadow ray is found by the tracer's closestHit.
std::vector<Arrow> arrowsOf(const SampleRecord&, const World&, int sample, float reach);

/// At most `most` of the arrows, those of the largest weight and ray `kept` of sample 0, in their order.
std::vector<Arrow> weightiest(std::vector<Arrow>, std::size_t most, int kept);

}
