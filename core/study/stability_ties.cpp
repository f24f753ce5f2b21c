// Ties and trees: F17, F19, F26.

#include "core/geometry/accel.h"
#include "core/geometry/textbook_tree.h"
#include "core/geometry/textbook_triangle.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"

namespace eyeray {
namespace {

/// One triangle twice, its corners in another order, and a ray at it.
struct Twins {
    std::array<Vec3, 3> corners;
    Ray ray;

    /// Of the first or the second one.
    Vec3 corner(int which, std::size_t i) const { return corners[(i + static_cast<std::size_t>(which)) % 3]; }
};

// Both lie in the same place, so the first is to be seen.
MeasuredForms coplanar(double tilt, const StabilityEffort& effort) {
    const double lean = radians(tilt);
    const auto inputs = inputsOf(effort.trials, 17, [&](TrialNumbers& numbers) {
        Twins twins;
        for (Vec3& corner : twins.corners) {
            const DVec3 p = numbers.inCube(2);
            corner = Vec3(DVec3(p.x, p.y * std::cos(lean), p.y * std::sin(lean)));
        }
        const double u = numbers.uniform(0.1, 0.4), v = numbers.uniform(0.1, 0.4);
        const DVec3 a(twins.corners[0]), b(twins.corners[1]), c(twins.corners[2]);
        const DVec3 origin(Vec3(numbers.uniform(-1, 1), numbers.uniform(-1, 1), 5));
        twins.ray = rayFrom(origin, glm::normalize(a + u * (b - a) + v * (c - a) - origin));
        return twins;
    });
    return compared(
        inputs, effort,
        [](const Twins& in, auto type) {
            using T = decltype(type);
            const textbook::RayOf<T> ray(in.ray);
            const auto t = [&](int which) {
                const auto corner = [&](std::size_t i) { return textbook::Vector<T>(in.corner(which, i)); };
                const auto hit = textbook::intersectTriangle<T>({corner(0), corner(1), corner(2)}, ray, T(0));
                return hit ? hit->t : std::numeric_limits<T>::infinity();
            };
            return t(1) < t(0);
        },
        [](const Twins& in) {
            const RayShear shear(in.ray);
            const auto t = [&](int which) {
                const auto corner = [&](std::size_t i) { return toArray(in.corner(which, i)); };
                const auto hit = intersectCorners({corner(0), corner(1), corner(2)}, true, shear, in.ray.tMin,
                                                  in.ray.tMax);
                return hit ? hit->t : kInfinity;
            };
            return t(1) < t(0);
        },
        [](const Twins&, bool secondIsNearer) { return secondIsNearer; });
}

// Which side of b a lies on, and which side of a b lies on, in the plane: one is minus the other.
MeasuredForms sides(double angle, const StabilityEffort& effort) {
    struct Input {
        Vec2 a, b;
    };
    const auto inputs = inputsOf(effort.trials, 19, [&](TrialNumbers& numbers) {
        const double at = numbers.uniform(0, 2 * kPiD), far = numbers.uniform(0.5, 2);
        return Input{Vec2(std::cos(at), std::sin(at)),
                     Vec2(far * std::cos(at + angle), far * std::sin(at + angle))};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> double {
            using V = glm::vec<2, decltype(type)>;
            const V a(in.a), b(in.b);
            return textbook::contractedSide(a, b) + textbook::contractedSide(b, a);
        },
        [](const Input& in) -> double {
            const auto side = [](const Vec2& p, const Vec2& q) { return p.x * q.y - p.y * q.x; };
            return side(in.a, in.b) + side(in.b, in.a);
        },
        [](const Input&, double sum) -> Verdict { return {std::fabs(sum), sum != 0}; });
}

int depthOf(const Bvh2& tree) {
    struct Place {
        std::size_t node;
        int depth;
    };
    int deepest = 0;
    std::vector<Place> places = {{0, 0}};
    while (!places.empty()) {
        const auto [at, depth] = places.back();
        places.pop_back();
        const Bvh2::Node& node = tree.nodes()[at];
        deepest = std::max(deepest, depth);
        if (node.count > 0) continue;
        places.push_back({node.first, depth + 1});
        places.push_back({node.first + 1, depth + 1});
    }
    return deepest;
}

// Boxes that grow by powers of two from one corner, as near and far things in one scene do.
MeasuredForms growingBoxes(double count, const StabilityEffort& effort) {
    std::vector<Bounds> boxes;
    for (int i = 0; i < static_cast<int>(count); ++i) {
        const auto size = static_cast<float>(std::ldexp(1.0, i - static_cast<int>(count) / 2));
        boxes.push_back({Vec3(size), Vec3(1.5F * size)});
    }
    const std::vector<int> builds(4);
    const auto judge = [](int, int depth) -> Verdict {
        return {static_cast<double>(depth), depth > Bvh2::kMaxDepth};
    };
    const auto naive = [&](auto type) {
        using T = decltype(type);
        return tried(
            builds, effort,
            [&](int) {
                std::vector<textbook::Vector<T>> middles;
                middles.reserve(boxes.size());
                for (const Bounds& box : boxes) middles.emplace_back(box.center());
                return textbook::midpointDepth<T>(middles);
            },
            judge);
    };
    const auto robust = tried(builds, effort, [&](int) { return depthOf(Bvh2(boxes, 1, {})); }, judge);
    return {naive(float()), naive(double()), robust};
}

}

std::vector<StabilityCase> tieCases() {
    return {
        {.id = "F17",
         .title = "Two surfaces in one place",
         .why = "the same triangle from another corner rounds t another way: which is nearer is chance",
         .fix = "t by the plane in double, rounded once; of equal ones the lower number. And gaps in models",
         .parameter = "tilt of both, degrees",
         .error = "share of rays that see the second one",
         .failure = "rays that see the second one",
         .sweep = steps(0, 80, 10),
         .logarithmic = false,
         .mark = {1e-4, 100},
         .measure = coplanar},
        {.id = "F19",
         .title = "Products contracted to FMA",
         .why = "a·b − c·d with one product rounded and the other not: neighbours disagree about their edge",
         .fix = "compiled with -ffp-contract=off",
         .parameter = "angle of both directions, radians",
         .error = "side(a, b) + side(b, a), which is 0",
         .failure = "not 0",
         .sweep = decades(-7, 0),
         .showsFailures = true,
         .mark = {0, 0},
         .measure = sides},
        {.id = "F26",
         .title = "Trees as deep as a list",
         .why = "halving space takes one box off a row that grows by powers of two: the stack overflows",
         .fix = "the surface area heuristic, halves by number where that fails or depth runs out",
         .parameter = "boxes, each twice as large as the last",
         .error = "depth of the tree",
         .failure = "deeper than a stack of 64",
         .sweep = {8, 16, 32, 64, 128, 240},
         .mark = {Bvh2::kMaxDepth, 0},
         .measure = growingBoxes},
    };
}

}
