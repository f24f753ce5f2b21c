// Boxes and planes: F12 to F16.

#include "core/geometry/shapes.h"
#include "core/geometry/slab.h"
#include "core/geometry/textbook_box.h"
#include "core/geometry/textbook_plane.h"
#include "core/geometry/textbook_slab.h"
#include "core/geometry/triangle.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"

namespace eyeray {
namespace {

/// A ray that touches the box in truth. In doubt a box is to be searched, so others do not count.
struct Boxed {
    Bounds box;
    Ray ray;
};

// Axes that the ray runs along apart; all else in long double.
bool touches(const Bounds& box, const Ray& ray) {
    Real in = ray.tMin, out = ray.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const Real o = ray.origin[axis], d = ray.direction[axis], lo = box.lo[axis], hi = box.hi[axis];
        if (d == 0 && (o < lo || o > hi)) return false;
        if (d == 0) continue;
        in = std::fmax(in, std::fmin((lo - o) / d, (hi - o) / d));
        out = std::fmin(out, std::fmax((lo - o) / d, (hi - o) / d));
    }
    return in <= out;
}

/// The first of the boxes and rays that `make` returns for which that is so.
template <class Make>
std::vector<Boxed> touching(int trials, std::uint32_t seed, const Make& make) {
    return inputsOf(trials, seed, [&](TrialNumbers& numbers) {
        Boxed made = make(numbers);
        while (!touches(made.box, made.ray)) made = make(numbers);
        return made;
    });
}

bool culledBy(const Boxed& in) {
    const RaySlab slab(in.ray, in.box);
    const auto enter = slab.enter({toArray(in.box.lo), toArray(in.box.hi)}, in.ray.tMax);
    return !(enter < kInfinity);
}

constexpr auto minMax = [](const Boxed& in, auto type) {
    using V = textbook::Vector<decltype(type)>;
    return !textbook::meetsSlabs(V(in.box.lo), V(in.box.hi), textbook::RayOf<decltype(type)>(in.ray));
};
constexpr auto breakingOff = [](const Boxed& in, auto type) {
    using V = textbook::Vector<decltype(type)>;
    return !textbook::meetsThickSlabs(V(in.box.lo), V(in.box.hi), textbook::RayOf<decltype(type)>(in.ray));
};
constexpr auto isLost = [](const Boxed&, bool culled) { return culled; };

MeasuredForms alongFaces(double scale, const StabilityEffort& effort) {
    const auto inputs = touching(effort.trials, 12, [&](TrialNumbers& numbers) {
        constexpr std::array kComponents = {-1.0F, -0.0F, 0.0F, 1.0F};
        Vec3 origin, direction;
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = static_cast<float>(scale * (numbers.below(5) - 2));
            direction[axis] = kComponents[static_cast<std::size_t>(numbers.below(4))];
        }
        if (direction == Vec3(0)) direction.z = 1;
        return Boxed{{Vec3(static_cast<float>(-scale)), Vec3(static_cast<float>(scale))},
                     {.origin = origin, .direction = direction}};
    });
    return compared(inputs, effort, minMax, culledBy, isLost);
}

MeasuredForms flatBox(double thickness, const StabilityEffort& effort) {
    const auto inputs = touching(effort.trials, 13, [&](TrialNumbers& numbers) {
        const Bounds box{Vec3(-1, -1, 0), Vec3(1, 1, static_cast<float>(thickness))};
        DVec3 target = numbers.inCube(0.9), origin = numbers.inCube(1);
        target.z = 0;
        origin.z = numbers.uniform(4, 5);
        return Boxed{box, rayFrom(origin, target - inFloat(origin))};
    });
    return compared(inputs, effort, breakingOff, culledBy, isLost);
}

MeasuredForms atEdges(double distance, const StabilityEffort& effort) {
    const auto inputs = touching(effort.trials, 14, [&](TrialNumbers& numbers) {
        const DVec3 lo = numbers.inCube(1), hi = lo + DVec3(numbers.uniform(0.01, 1));
        const Bounds box{Vec3(lo), Vec3(hi)};
        DVec3 onEdge;
        for (int axis = 0; axis < 3; ++axis)
            onEdge[axis] = numbers.below(2) == 0 ? box.lo[axis] : box.hi[axis];
        const int along = numbers.below(3);
        onEdge[along] = numbers.uniform(box.lo[along], box.hi[along]);
        const DVec3 origin(Vec3(distance * numbers.direction()));
        return Boxed{box, rayFrom(origin, onEdge - origin)};
    });
    return compared(inputs, effort, minMax, culledBy, isLost);
}

MeasuredForms boxFace(double scale, const StabilityEffort& effort) {
    struct Input {
        Box box;
        Ray ray;
        float t;
        Vec3 normal;
    };
    const auto inputs = inputsOf(effort.trials, 15, [&](TrialNumbers& numbers) {
        const Box box{Vec3(scale * DVec3(numbers.uniform(0.5, 2), numbers.uniform(0.5, 2), 1))};
        const int axis = numbers.below(3);
        const double side = numbers.below(2) == 0 ? -1 : 1;
        DVec3 target = 0.49 * DVec3(box.size) * numbers.inCube(1); // away from the edges
        target[axis] = 0.5 * side * box.size[axis];
        DVec3 origin = numbers.inCube(3 * scale);
        origin[axis] = side * numbers.uniform(1.5, 3) * scale;
        Vec3 normal(0);
        normal[axis] = static_cast<float>(side);
        const DVec3 start = inFloat(origin);
        const Ray ray = rayFrom(start, glm::normalize(target - start));
        return Input{box, ray, static_cast<float>(glm::length(target - start)), normal};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) {
            using T = decltype(type);
            const textbook::Vector<T> half = T(0.5) * textbook::Vector<T>(in.box.size);
            return Vec3(textbook::boxNormal(textbook::RayOf<T>(in.ray).at(in.t), half, T(1e-4)));
        },
        [](const Input& in) {
            const auto hit = intersect(in.box, in.ray);
            return hit ? surfaceAt(in.box, in.ray, *hit).geometricNormal : Vec3(0);
        },
        [](const Input& in, const Vec3& normal) { return normal != in.normal; });
}

MeasuredForms grazingPlane(double slope, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
        std::optional<double> t; // in truth
    };
    const auto inputs = inputsOf(effort.trials, 16, [&](TrialNumbers& numbers) {
        const double around = numbers.uniform(0, 2 * kPiD);
        const int kind = numbers.below(10); // in the plane, along it, or towards it
        const DVec3 direction(std::cos(around), kind < 2 ? 0 : -slope, std::sin(around));
        const Ray ray = rayFrom({numbers.uniform(-1, 1), kind == 0 ? 0 : 1.7, 0}, direction);
        if (kind < 2) return Input{ray, {}};
        return Input{ray, -static_cast<double>(ray.origin.y) / ray.direction.y};
    });
    return compared(
        inputs, effort,
        [](const Input& in, auto type) -> std::optional<double> {
            using T = decltype(type);
            return textbook::intersectPlane<T>({0, 1, 0}, 0, textbook::RayOf<T>(in.ray));
        },
        [](const Input& in) -> std::optional<double> {
            const auto hit = intersect(Plane{.doubleSided = true}, in.ray);
            return hit ? std::optional<double>(hit->t) : std::nullopt;
        },
        [](const Input& in, const std::optional<double>& t) -> Verdict {
            if (t.has_value() != in.t.has_value()) return {0, true};
            return {t ? std::fabs(*t / *in.t - 1) : 0};
        });
}

}

std::vector<StabilityCase> boxCases() {
    return {
        {.id = "F12",
         .title = "0 · ∞ in the slab test",
         .why = "for a ray along a face, from its plane, a slab begins at NaN, and std::min or max keeps it",
         .fix = "1/0 stands as the largest float, and comparisons keep the old value (Williams et al. 2005)",
         .parameter = "size of a box, m",
         .error = "share of rays that lose the box",
         .failure = "boxes that are touched and lost, of origins and directions on a lattice",
         .sweep = decades(-3, 3),
         .mark = {0, 0},
         .measure = alongFaces},
        {.id = "F13",
         .title = "Boxes without thickness",
         .why = "\"leaves ≤ enters\" counts as a miss, and both are the same float",
         .fix = "only enters > leaves is a miss",
         .parameter = "thickness of a box 4 m away, m",
         .error = "share of rays that lose the box",
         .failure = "boxes that are hit and lost",
         .sweep = decades(-18, 0, 1),
         .mark = {0, 0},
         .measure = flatBox},
        {.id = "F14",
         .title = "Rounding in the slab test",
         .why = "each slab's ends are rounded for themselves: a ray at an edge leaves before it enters",
         .fix = "the end is multiplied by 1 + 2γ₃ (Ize 2013, JCGT 2(2))",
         .parameter = "distance of the eye, m",
         .error = "share of rays that lose the box",
         .failure = "boxes that are touched at an edge and lost",
         .sweep = decades(1, 5, 2),
         .mark = {0, 0},
         .measure = atEdges},
        {.id = "F15",
         .title = "Normal of a box by an epsilon",
         .why =
             "a point is on a face if within 10⁻⁴ of it: on none in a large box, on several in a small one",
         .fix = "the slab that gave t is the face",
         .parameter = "size of the box, m",
         .error = "share of wrong normals",
         .failure = "normals that are not the face's",
         .sweep = decades(-5, 5),
         .mark = {0, 0},
         .measure = boxFace},
        {.id = "F16",
         .title = "Rays in a plane",
         .why = "0/0 is NaN, and a test that asks what is outside lets it in",
         .fix = "asks what is inside: !(t > tMin && t < tMax) is a miss",
         .parameter = "slope of the other rays",
         .error = "relative error of t",
         .failure = "hits of a plane that the ray lies in or runs along",
         .sweep = decades(-6, 0),
         .showsFailures = true,
         .mark = {1e-6, 0},
         .measure = grazingPlane},
    };
}

}
