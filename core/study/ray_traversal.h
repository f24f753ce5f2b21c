#pragma once
// The work that rays on record made for the index over the scene.

#include <string>

#include "core/geometry/traversal_log.h"
#include "core/scene/world.h"
#include "core/transport/recorder.h"
#include "core/transport/settings.h"

namespace eyeray {

/// Sends a ray on record through the World's index once more, alone, and puts down what it goes through: the
/// nearest hit of eye, reflected, refracted and diffuse rays; of a shadow ray any hit and, by the rules of
/// these settings, the glass along its way.
void logTraversal(const World&, const TraceSettings&, const SampleRecord&, int ray, TraversalLog&);

/// Of one ray.
TraversalCounts traversalOf(const World&, const TraceSettings&, const SampleRecord&, int ray);

/// Of all rays of a sample.
TraversalCounts traversalOf(const World&, const TraceSettings&, const SampleRecord&);

/// "bvh8: 9 boxes in 2 nodes, then 4 of 70 000 primitives"; by brute force "no index: 4 of 4 primitives".
std::string traversalText(const TraversalCounts&, const World&);

}
