// Triangles: F07 to F11, F34.

#include <map>

#include "core/geometry/accel.h"
#include "core/geometry/textbook_triangle.h"
#include "core/study/stability_groups.h"
#include "core/study/stability_trials.h"
#include "core/transport/shading_point.h"

namespace eyeray {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A closed mesh: an octahedron with each face cut in four and blown up to the unit sphere, `levels` times.
TriangleMesh octahedralBall(int levels) {
    TriangleMesh ball;
    ball.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    ball.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, isNew] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(ball.positions.size()));
            if (isNew)
                ball.positions.emplace_back(
                    glm::normalize(DVec3(ball.positions[a]) + DVec3(ball.positions[b])));
            return at->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : ball.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const Triangle& part : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
                finer.push_back(part);
        }
        ball.triangles = std::move(finer);
    }
    return ball;
}

/// The triangles that share a vertex with each triangle, itself among them.
std::vector<std::vector<std::uint32_t>> surroundings(const TriangleMesh& mesh) {
    std::vector<std::vector<std::uint32_t>> at(mesh.positions.size()), around(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t vertex : mesh.triangles[i]) at[vertex].push_back(i);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::uint32_t vertex : mesh.triangles[i])
            around[i].insert(around[i].end(), at[vertex].begin(), at[vertex].end());
    return around;
}

template <class T>
textbook::Corners<T> cornersIn(const TriangleMesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {textbook::Vector<T>(mesh.positions[a]), textbook::Vector<T>(mesh.positions[b]),
            textbook::Vector<T>(mesh.positions[c])};
}

int levelsFor(double triangles) { return static_cast<int>(std::lround(std::log2(triangles / 8) / 2)); }

MeasuredForms leaks(double triangles, const StabilityEffort& effort) {
    struct Input {
        Ray ray;
        std::uint32_t triangle; // whose edge or corner it is aimed at
    };
    const TriangleMesh ball = octahedralBall(levelsFor(triangles));
    const auto around = surroundings(ball);
    const auto inputs = inputsOf(effort.trials, 7, [&](TrialNumbers& numbers) {
        const auto triangle =
            static_cast<std::uint32_t>(numbers.below(static_cast<int>(ball.triangles.size())));
        const auto corner = static_cast<std::size_t>(numbers.below(3));
        const DVec3 a(ball.positions[ball.triangles[triangle][corner]]),
            b(ball.positions[ball.triangles[triangle][(corner + 1) % 3]]);
        const double share = numbers.below(2) == 0 ? 0.0 : numbers.uniform(0, 1);
        const DVec3 origin(Vec3(numbers.inCube(0.3)));
        return Input{rayFrom(origin, a + share * (b - a) - origin), triangle};
    });
    return compared(
        inputs, effort,
        [&](const Input& in, auto type) {
            using T = decltype(type);
            const textbook::RayOf<T> ray(in.ray);
            return std::ranges::any_of(around[in.triangle], [&](std::uint32_t i) {
                return textbook::intersectTriangle<T>(cornersIn<T>(ball, i), ray, 0).has_value();
            });
        },
        [&](const Input& in) {
            const RayShear shear(in.ray);
            return std::ranges::any_of(around[in.triangle], [&](std::uint32_t i) {
                return intersectTriangle(ball, i, shear, in.ray).has_value();
            });
        },
        [](const Input&, bool held) { return !held; });
}

// Shadow rays from a smooth ball to lamps that its normals call visible: nothing is in their way.
MeasuredForms terminator(double triangles, const StabilityEffort& effort) {
    struct Input {
        ShadingPoint point;
        Vec3 toLamp;
    };
    TriangleMesh ball = octahedralBall(levelsFor(triangles));
    ball.normals = ball.positions;
    const auto mesh = std::make_shared<const TriangleMesh>(std::move(ball));
    const auto geometry =
        indexInstances<Bvh2>({{.placement = Placement(), .geometry = indexMesh<Bvh2>(mesh, {})}}, {});
    const auto inputs = inputsOf(effort.trials, 34, [&](TrialNumbers& numbers) {
        while (true) {
            const DVec3 eye = 5.0 * numbers.direction(), target = numbers.inCube(0.6);
            const Ray ray = rayFrom(eye, glm::normalize(target - eye));
            const auto hit = closestHit(geometry, ray);
            if (!hit) continue;
            ShadingPoint point{};
            point.at = surfaceAt(geometry, ray, *hit);
            point.wo = -ray.direction;
            point.normal = point.at.shadingNormal;
            point.geometricNormal = point.at.geometricNormal;
            const Vec3 toLamp(numbers.direction());
            if (glm::dot(point.normal, toLamp) > 0 && glm::dot(point.normal, point.wo) > 0)
                return Input{point, toLamp};
        }
    });
    const auto shaded = [&](const Vec3& origin, const Vec3& toLamp) {
        return anyHit(geometry, {.origin = origin, .direction = toLamp});
    };
    const auto judge = [](const Input&, bool isShaded) { return isShaded; };
    return {
        tried(
            inputs, effort,
            [&](const Input& in) { return shaded(spawnOrigin(in.point.at, in.toLamp), in.toLamp); }, judge),
        std::nullopt,
        tried(
            inputs, effort,
            [&](const Input& in) { return shaded(shadowOrigin(in.point, in.toLamp), in.toLamp); }, judge)};
}

/// One triangle of its own in float, and a ray at it.
struct Aimed {
    TriangleCorners corners;
    Ray ray;
    double t = 0;
};

template <class T>
textbook::Corners<T> cornersIn(const TriangleCorners& corners) {
    const auto in = [](const std::array<float, 3>& p) { return textbook::Vector<T>(p[0], p[1], p[2]); };
    return {in(corners[0]), in(corners[1]), in(corners[2])};
}

std::optional<double> hitBy(const Aimed& in) {
    const auto hit = intersectCorners(in.corners, true, RayShear(in.ray), in.ray.tMin, in.ray.tMax);
    return hit ? std::optional<double>(hit->t) : std::nullopt;
}

template <class T>
std::optional<double> textbookHit(const Aimed& in, T epsilon) {
    const auto hit =
        textbook::intersectTriangle<T>(cornersIn<T>(in.corners), textbook::RayOf<T>(in.ray), epsilon);
    return hit ? std::optional<double>(hit->t) : std::nullopt;
}

MeasuredForms smallTriangle(double leg, const StabilityEffort& effort) {
    const auto inputs = inputsOf(effort.trials, 8, [&](TrialNumbers& numbers) {
        const double u = numbers.uniform(0.1, 0.4), v = numbers.uniform(0.1, 0.4);
        const auto side = static_cast<float>(leg);
        return Aimed{
            {{{0, 0, 0}, {side, 0, 0}, {0, side, 0}}}, rayFrom({u * leg, v * leg, 10}, {0, 0, -1}), 10};
    });
    return compared(
        inputs, effort,
        [](const Aimed& in, auto type) {
            using T = decltype(type);
            return textbookHit<T>(in, T(textbook::kMollerTrumboreEpsilon));
        },
        hitBy,
        [](const Aimed& in, const std::optional<double>& t) -> Verdict {
            if (!t) return {0, true};
            return {std::fabs(*t / in.t - 1), false};
        });
}

MeasuredForms zeroArea(double scale, const StabilityEffort& effort) {
    const auto inputs = inputsOf(effort.trials, 9, [&](TrialNumbers& numbers) {
        const Vec3 a(numbers.inCube(scale)), b(numbers.inCube(scale));
        const int kind = numbers.below(3); // two corners in one place, or all, or three along an axis
        Vec3 c = kind == 0 ? a : b;
        if (kind == 2) c = Vec3(b.x, a.y, a.z);
        const Vec3 second = kind == 1 ? a : kind == 2 ? Vec3(0.5F * (a.x + b.x), a.y, a.z) : b;
        if (kind == 1) c = a;
        const DVec3 origin(Vec3(numbers.inCube(4 * scale)));
        const DVec3 target = 0.5 * (DVec3(a) + DVec3(second));
        return Aimed{{toArray(a), toArray(second), toArray(c)}, rayFrom(origin, target - origin), 0};
    });
    return compared(
        inputs, effort,
        [](const Aimed& in, auto type) {
            using T = decltype(type);
            return textbookHit<T>(in, 0);
        },
        hitBy, [](const Aimed&, const std::optional<double>& t) { return t.has_value(); });
}

/// A triangle whose normal is asked for.
struct Faced {
    TriangleMesh mesh;
    DVec3 normal;
};

Faced facedBy(const std::array<DVec3, 3>& corners) {
    using V = glm::vec<3, Real>;
    Faced faced;
    for (const DVec3& p : corners) faced.mesh.positions.emplace_back(p);
    faced.mesh.triangles = {{0, 1, 2}};
    const auto& p = faced.mesh.positions;
    const V normal = glm::cross(V(p[1]) - V(p[0]), V(p[2]) - V(p[0]));
    const Real length = std::sqrt(glm::dot(normal, normal));
    if (length > 0) faced.normal = DVec3(normal / length);
    return faced;
}

MeasuredForms normals(const std::vector<Faced>& inputs, const StabilityEffort& effort) {
    return compared(
        inputs, effort,
        [](const Faced& in, auto type) {
            using T = decltype(type);
            const auto corners = cornersIn<T>(in.mesh, 0);
            return DVec3(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
        },
        [](const Faced& in) {
            return DVec3(surfaceAt(in.mesh, {0, 0, -1}, Hit{.u = 0.25F, .v = 0.25F}).geometricNormal);
        },
        [](const Faced& in, const DVec3& normal) -> Verdict {
            const double error = glm::length(normal - in.normal);
            return {error, !(error < 1e-3)};
        });
}

constexpr int kCostly = 10; // times as much as a ray

MeasuredForms needle(double ratio, const StabilityEffort& effort) {
    return normals(inputsOf(effort.trials / kCostly, 10,
                            [&](TrialNumbers& numbers) {
                                const DVec3 a = 10.0 * numbers.direction(), along = numbers.direction();
                                const DVec3 across = glm::cross(along, numbers.direction()) / ratio;
                                return facedBy({a, a + along, a + 0.5 * along + across});
                            }),
                   effort);
}

MeasuredForms extremeTriangle(double leg, const StabilityEffort& effort) {
    return normals(inputsOf(effort.trials / kCostly, 11,
                            [&](TrialNumbers& numbers) {
                                return facedBy({leg * numbers.direction(), leg * numbers.direction(),
                                                leg * numbers.direction()});
                            }),
                   effort);
}

}

std::vector<StabilityCase> triangleCases() {
    return {
        {.id = "F07",
         .title = "Leaks at shared edges and corners",
         .why = "each triangle rounds u and v for itself, so that two neighbours may both say \"outside\"",
         .fix = "the watertight test (Woop, Benthin, Wald 2013, JCGT 2(1)), compiled without contraction",
         .parameter = "triangles of a closed ball",
         .error = "share of rays that get out",
         .failure = "rays aimed at edges and corners from inside that get out",
         .sweep = {32, 128, 512, 2048, 8192, 32768},
         .mark = {0, 0},
         .measure = leaks},
        {.id = "F08",
         .title = "Small triangles culled",
         .why = "a determinant below 10⁻⁶ counts as parallel, and it shrinks with the triangle's area",
         .fix = "only exactly 0 is none (Woop, Benthin, Wald 2013)",
         .parameter = "legs, m (10 m away)",
         .error = "relative error of t",
         .failure = "hits that are missed",
         .sweep = decades(-15, 0),
         .showsFailures = true,
         .mark = {1e-6, 0},
         .measure = smallTriangle},
        {.id = "F09",
         .title = "Triangles without area",
         .why = "1/0 makes NaN, which passes tests of the form u < 0",
         .fix = "a cross product of 0 is no hit (Pharr, Jakob, Humphreys 2023, 6.5)",
         .parameter = "size, m",
         .error = "share of rays that hit",
         .failure = "hits of a point or a line",
         .sweep = decades(-4, 4),
         .mark = {0, 0},
         .measure = zeroArea},
        {.id = "F10",
         .title = "Normals of slivers",
         .why = "the cross product of two nearly parallel edges cancels",
         .fix = "edges of float vertices and their cross product in double",
         .parameter = "length / width of a needle (10 m from the origin)",
         .error = "length of the normal's error",
         .failure = "off by more than 10⁻³, or not a number",
         .sweep = decades(1, 5),
         .mark = {1e-6, 0},
         .measure = needle},
        {.id = "F11",
         .title = "Normals of extreme sizes",
         .why = "|n|² grows with the fourth power of the size: it under- or overflows",
         .fix = "double, scaled by the largest component where that is not enough",
         .parameter = "legs, m",
         .error = "length of the normal's error",
         .failure = "off by more than 10⁻³, or not a number",
         .sweep = decades(-15, 15),
         .showsFailures = true,
         .mark = {1e-6, 0},
         .measure = extremeTriangle},
        {.id = "F34",
         .title = "Facets black that the normals call lit",
         .why = "the lamp is above the smooth surface and below the plane of its facet",
         .fix =
             "shadow rays start on the rounded surface that the normals stand for (Hanika 2021, Ray Tracing "
             "Gems II 4)",
         .parameter = "triangles of a smooth ball",
         .error = "share of lit points that are black",
         .failure = "points that are lit, and that the ball's own facets shade",
         .sweep = {32, 128, 512, 2048, 8192, 32768},
         .mark = {0, 0},
         .measure = terminator},
    };
}

}
