// Lamps: F47.

#include "core/geometry/accel.h"
#include "core/geometry/textbook_triangle.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"

namespace eyeray {
namespace {

// A shadow ray to a random point of a lamp of two triangles, up to t = 1: what is hit can only be the lamp.
MeasuredForms selfShadow(double scale, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
    };
    TriangleMesh lamp;
    for (const auto& [x, z] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        lamp.positions.emplace_back(scale * DVec3(x, 3, z + 0.3 * x));
    lamp.triangles = {{0, 1, 2}, {0, 2, 3}};
    const auto shared = std::make_shared<const TriangleMesh>(lamp);
    const auto geometry = indexInstances<Bvh2>(
        {{.placement = Placement(), .geometry = indexMesh<Bvh2>(shared, {}), .mask = RayMask::Lamp}}, {});
    const auto inputs = inputsOf(effort.trials, 47, [&](TrialNumbers& numbers) {
        double u = numbers.uniform(0, 1), v = numbers.uniform(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        const auto& p = lamp.positions;
        const Vec3 target =
            p[0] + static_cast<float>(u) * (p[1] - p[0]) + static_cast<float>(v) * (p[2] - p[0]);
        const DVec3 from = numbers.inCube(scale);
        return Input{{.origin = Vec3(from), .direction = target - Vec3(from), .tMax = 1}};
    });
    return compared(
        inputs, effort,
        [&](const Input& in, auto type) {
            using T = decltype(type);
            const auto corner = [&](std::size_t i) { return textbook::Vector<T>(lamp.positions[i]); };
            return textbook::intersectTriangle<T>({corner(0), corner(1), corner(2)},
                                                  textbook::RayOf<T>(in.ray), 0)
                .has_value();
        },
        [&](const Input& in) { return anyHit(geometry, in.ray, RayMask::Objects); },
        [](const Input&, bool shadowed) { return shadowed; });
}

}

std::vector<StabilityCase> lampCases() {
    return {
        {.id = "F47",
         .title = "A lamp that shades itself",
         .why = "t of a shadow ray that ends on the lamp is 1, or by rounding less",
         .fix = "shadow rays do not see the surfaces of lamps",
         .parameter = "scale of the scene",
         .error = "share of shadow rays that are stopped",
         .failure = "shadow rays that the lamp itself stops",
         .sweep = decades(-3, 5),
         .mark = {0, 0},
         .measure = selfShadow},
    };
}

}
