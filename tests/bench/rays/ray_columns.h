#pragma once
// Rays in columns, from which all tracers take their packets.

#include <span>
#include <vector>

#include "core/geometry/ray.h"

namespace eyeray::bench {

struct RayColumns {
    static constexpr std::size_t kSpare = 16; // numbers that may be read beyond the last ray

    explicit RayColumns(std::span<const Ray> rays) : size(rays.size()) {
        const auto column = [&](std::vector<float>& numbers, const auto& of) {
            numbers.resize(rays.size() + kSpare);
            for (std::size_t i = 0; i < rays.size(); ++i) numbers[i] = of(rays[i]);
        };
        for (int axis = 0; axis < 3; ++axis) {
            column(origin[static_cast<std::size_t>(axis)], [=](const Ray& ray) { return ray.origin[axis]; });
            column(direction[static_cast<std::size_t>(axis)],
                   [=](const Ray& ray) { return ray.direction[axis]; });
        }
        column(tMin, [](const Ray& ray) { return ray.tMin; });
        column(tMax, [](const Ray& ray) { return ray.tMax; });
    }

    std::size_t size;
    std::array<std::vector<float>, 3> origin, direction; // by axis
    std::vector<float> tMin, tMax;
};

}
