#pragma once
// The nearest of the hits that an index comes across.

#include <optional>
#include <tuple>

#include "core/geometry/ray.h"

namespace eyeray {

/// Equal t: the lower (instance, primitive) wins, in whatever order they come.
class NearestHit {
public:
    explicit NearestHit(float tMax) : limit_(tMax) {}
    explicit NearestHit(const Ray& ray) : NearestHit(ray.tMax) {}

    void offer(const Hit& hit) {
        if (hit.t < best_.t ||
            std::tie(hit.instance, hit.primitive) < std::tie(best_.instance, best_.primitive)) {
            best_ = hit;
            limit_ = nextAbove(hit.t); // an equal t is still heard of
        }
    }
    /// Hits at this t and beyond change nothing.
    const float& limit() const { return limit_; }
    std::optional<Hit> get() const { return best_.t < kInfinity ? std::optional(best_) : std::nullopt; }

private:
    Hit best_;
    float limit_;
};

}
