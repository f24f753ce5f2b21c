#pragma once
// Rays of each kind through a scene, and how long an index takes to trace them.

#include <span>
#include <vector>

#include "core/base/ray_kind.h"
#include "core/base/thread_pool.h"
#include "core/geometry/accel.h"
#include "core/geometry/traversal_log.h"
#include "core/scene/world.h"
#include "core/transport/trace_context.h"

namespace eyeray {

/// A series of measurements: its median, and half its interquartile range.
struct Series {
    double median = 0, spread = 0;
};
Series seriesOf(std::vector<double> values);

/// The smallest of ascending values that `share` of all do not exceed (nearest rank).
double percentile(std::span<const double> ascending, double share);

struct RaySet {
    RayKind kind = RayKind::Eye;
    bool anyHit = false; // what is asked of its rays; else the closest hit
    std::vector<Ray> rays;
};

/// Eye rays of a picture of side·side pixels, in blocks of 8 by 8 (`side` is a multiple of 8) of four squares
/// each, and from what each hits: a shadow ray to one of the lamps in turn, a mirrored ray, and one in a
/// random direction over the surface (cosine distributed). The same for every index.
template <class Index>
std::vector<RaySet> raySets(const IndexedGeometry<Index>&, const EyeRays&, int side,
                            std::span<const Vec3> lamps);

/// The same through a World as its scene's camera sees it. Directional lamps stand far away; where no lamp
/// has a place, one is above the eye.
std::vector<RaySet> raySets(const World&, const Camera&, int side);

/// About `count` of the rays: whole blocks, one from anywhere in each of as many equal parts.
std::vector<Ray> thinned(std::span<const Ray>, std::size_t count);

struct TracedSet {
    double seconds = 0;
    std::size_t hits = 0;
};
/// Traces each ray of the set once, on all threads of the pool.
TracedSet trace(const Accel&, const RaySet&, ThreadPool&);

/// What the rays of the set go through in the index.
TraversalCounts countTraversal(const Accel&, const RaySet&);

}
