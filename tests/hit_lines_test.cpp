// labels: unit robustness
// Rays as text and what they hit: against closed forms, a second method, and each other by accelerator.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <sstream>

#include "core/base/errors.h"
#include "core/scene/generate.h"
#include "core/study/hit_lines.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;
using cases::Random;

std::string answersOf(const Scene& scene, const std::string& lines,
                      HitQuestion question = HitQuestion::Closest, AccelKind accel = AccelKind::Auto) {
    const HitLines hits(buildWorld(std::make_shared<const Scene>(scene), {accel}), question);
    const FloatEnvironment environment;
    std::string answers;
    hits.answer(lines, 1, answers);
    return answers;
}

std::string lineOf(const DVec3& origin, const DVec3& direction) {
    return fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g}\n", origin.x, origin.y, origin.z,
                       direction.x, direction.y, direction.z);
}

struct Answer {
    bool hit = false;
    double t = 0;
    std::uint64_t id = 0;
    DVec3 normal{0};
};

std::vector<Answer> parsed(const std::string& answers) {
    std::vector<Answer> result;
    std::istringstream lines(answers);
    for (std::string line; std::getline(lines, line);) {
        Answer a;
        a.hit = line != "miss";
        if (a.hit) std::istringstream(line) >> a.t >> a.id >> a.normal.x >> a.normal.y >> a.normal.z;
        result.push_back(a);
    }
    return result;
}

TEST(HitLines, TellDistanceNumberAndNormal) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{2}, matte(Color(1)), at({0, 0, -10}));
    add(scene, Plane{}, matte(Color(1)), at({0, -3, 0}));
    EXPECT_EQ(answersOf(scene, "0 0 0 0 0 -1\n"), "8 0 0 0 1\n");
    EXPECT_EQ(answersOf(scene, "0 0 0 0 -1 0\n"), "3 1 0 1 0\n");
    EXPECT_EQ(answersOf(scene, "0 0 0 0 1 0\n"), "miss\n");
    EXPECT_EQ(answersOf(scene, "0 0 -10 0 0 -1\n"), "2 0 0 0 -1\n") << "from inside: still outward";
    EXPECT_EQ(answersOf(scene, "0 0 0 0 0 -4\n"), "2 0 0 0 1\n") << "t is in units of the direction";
    EXPECT_EQ(answersOf(scene, "0 0 0 0 0 -1 8 100\n"), "12 0 0 0 -1\n") << "beyond tmin";
    EXPECT_EQ(answersOf(scene, "0 0 0 0 0 -1 0 8\n"), "miss\n") << "short of tmax";
    EXPECT_EQ(answersOf(scene, "0 0 0 0 0 -1 0 inf\n"), "8 0 0 0 1\n");
}

TEST(HitLines, MayHaveDirectionsOfAnyLength) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{2}, matte(Color(1)), at({0, 0, -10}));
    for (const double length : {1e-300, 1e-39, 1e-20, 1e-3, 1e3, 1e20, 1e39, 1e300}) {
        const Answer a = parsed(answersOf(scene, fmt::format("0 0 0 0 0 {:.17g}", -length))).at(0);
        ASSERT_TRUE(a.hit) << length;
        EXPECT_NEAR(a.t * length, 8, 1e-6) << length; // the direction is rounded to floats
        EXPECT_EQ(answersOf(scene, fmt::format("0 0 0 0 0 {:.17g} {:.17g} {:.17g}", -length, 7.9 / length,
                                               8.1 / length)),
                  answersOf(scene, fmt::format("0 0 0 0 0 {:.17g}", -length)));
        EXPECT_EQ(answersOf(scene, fmt::format("0 0 0 0 0 {:.17g} 0 {:.17g}", -length, 7.9 / length)),
                  "miss\n");
    }
}

TEST(HitLines, CountPrimitivesInTheOrderOfTheSceneWhetherSeenOrNot) {
    Scene scene = underSky(Color(0));
    const TriangleMesh square{.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                              .normals = {},
                              .uvs = {},
                              .colors = {},
                              .triangles = {{0, 1, 2}, {0, 0, 0}, {0, 2, 3}}};
    add(scene, square, matte(Color(1)), at({0, 0, -2}));          // 0 to 2, of which 1 is no triangle
    add(scene, Box{{1, 1, 1}}, matte(Color(1)), at({10, 0, -2})); // 3
    add(scene, Sphere{1}, matte(Color(1)), at({20, 0, -2}));      // 4, hidden
    add(scene, square, matte(Color(1)), at({30, 0, -2}));         // 5 to 7
    scene.lights = {lampAt({40, 0, -5}, SphereLamp{1}), lampAt({50, 0, -5}, SphereLamp{1})}; // 8, 9
    scene.objects[2].visible = false;
    const std::string lines = "0.5 -0.2 0 0 0 -1\n-0.5 0.2 0 0 0 -1\n10 0 0 0 0 -1\n10 0 -5 0 0 1\n"
                              "20 0 0 0 0 -1\n30.5 -0.2 0 0 0 -1\n29.5 0.2 0 0 0 -1\n"
                              "40 0 0 0 0 -1\n50 0 0 0 0 -1\n";
    for (const AccelKind accel : {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8})
        EXPECT_EQ(answersOf(scene, lines, HitQuestion::Closest, accel),
                  "2 0 0 0 1\n2 2 0 0 1\n1.5 3 0 0 1\n2.5 3 0 0 -1\nmiss\n2 5 0 0 1\n2 7 0 0 1\n"
                  "4 8 0 0 1\n4 9 0 0 1\n");
}

/// t of a triangle by its plane and its three edges in long double; infinite for a miss.
long double secondMethod(const TriangleMesh& mesh, std::size_t triangle, const DVec3& origin,
                         const DVec3& direction) {
    using Vec = glm::vec<3, long double>;
    const auto& [a, b, c] = mesh.triangles[triangle];
    const Vec o(origin), d(direction), p(mesh.positions[a]), q(mesh.positions[b]), r(mesh.positions[c]);
    const Vec normal = glm::cross(q - p, r - p);
    const long double t = glm::dot(normal, p - o) / glm::dot(normal, d);
    const Vec x = o + t * d;
    const auto inside = [&](const Vec& from, const Vec& to) {
        return glm::dot(glm::cross(to - from, x - from), normal) >= 0;
    };
    const bool hit = t > 0 && inside(p, q) && inside(q, r) && inside(r, p);
    return hit ? t : std::numeric_limits<long double>::infinity();
}

TEST(HitLines, AgreeWithASecondMethodOnTriangles) {
    Random random(3);
    const TriangleMesh soup = cases::triangleSoup(random, 200, 1);
    Scene scene = underSky(Color(0));
    add(scene, soup, matte(Color(1)));
    std::string lines;
    std::vector<std::pair<DVec3, DVec3>> rays;
    for (int i = 0; i < 5000; ++i) {
        const DVec3 origin(Vec3(random.inCube(2)));
        rays.emplace_back(origin, DVec3(Vec3(random.inCube(1) - origin)));
        lines += lineOf(rays.back().first, rays.back().second);
    }
    const std::vector<Answer> answers = parsed(answersOf(scene, lines));
    ASSERT_EQ(answers.size(), rays.size());
    int other = 0, hits = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        long double nearest = std::numeric_limits<long double>::infinity();
        std::size_t id = 0;
        for (std::size_t k = 0; k < soup.triangles.size(); ++k) {
            const long double t = secondMethod(soup, k, rays[i].first, rays[i].second);
            if (t < nearest) std::tie(nearest, id) = std::pair(t, k);
        }
        if (answers[i].hit != std::isfinite(nearest) || (answers[i].hit && answers[i].id != id)) {
            ++other; // within the rounding of the World's own origin from an edge
            continue;
        }
        if (!answers[i].hit) continue;
        ++hits;
        ASSERT_NEAR(answers[i].t, static_cast<double>(nearest), 2e-5) << i;
    }
    EXPECT_LE(other, 1);
    EXPECT_GT(hits, 1000);
}

/// Rays from around the middle of generated balls and meshes.
std::string raysAmong(const DVec3& middle, double spread, int count) {
    Random random(4);
    std::string lines;
    for (int i = 0; i < count; ++i) lines += lineOf(middle + random.inCube(spread), random.direction());
    return lines;
}

TEST(HitLines, AreTheSameByAllAccelerators) {
    Scene balls = underSky(Color(0)), meshes = underSky(Color(0));
    for (const Ball& ball : makeFlake({.levels = 3}))
        add(balls, Sphere{static_cast<float>(ball.radius)}, matte(Color(1)), at(ball.center));
    add(meshes, makeKnot({.triangles = 3000}), matte(Color(1)));
    add(meshes, makeTerrain({.triangles = 2000}), matte(Color(1)), at({0, -1, 0}));
    for (const Scene& scene : {balls, meshes})
        for (const HitQuestion question : {HitQuestion::Closest, HitQuestion::Any, HitQuestion::Spawned}) {
            const std::string lines = raysAmong(boundsOf(scene).center(), boundsOf(scene).radius(), 3000);
            const std::string brute = answersOf(scene, lines, question, AccelKind::Brute);
            EXPECT_EQ(std::count(brute.begin(), brute.end(), '\n'), 3000);
            EXPECT_EQ(answersOf(scene, lines, question, AccelKind::Bvh2), brute);
            EXPECT_EQ(answersOf(scene, lines, question, AccelKind::Bvh8), brute);
        }
}

TEST(HitLines, OfAnyAgreeWithThoseOfTheClosest) {
    Scene scene = underSky(Color(0));
    add(scene, makeKnot({.triangles = 3000}), matte(Color(1)));
    const std::string lines = raysAmong(DVec3(0), 2, 5000);
    std::string expected;
    for (const Answer& a : parsed(answersOf(scene, lines))) expected += a.hit ? "1\n" : "0\n";
    EXPECT_EQ(answersOf(scene, lines, HitQuestion::Any), expected);
}

TEST(HitLines, HoldRaysAimedAtEdgesAndVerticesInAClosedMeshAnywhere) {
    const TriangleMesh mesh = cases::closedMesh(40, 60, 1);
    for (const DVec3& place : {DVec3(0), DVec3(1e4, 0, 0), DVec3(148376, 1234, -223423)}) {
        Scene scene = underSky(Color(0));
        add(scene, mesh, matte(Color(1)), at(place));
        Random random(5);
        std::string lines;
        for (int i = 0; i < 20'000; ++i) {
            const auto& triangle = random.oneOf(mesh.triangles);
            const DVec3 a(mesh.positions[triangle[0]]), b(mesh.positions[triangle[1]]);
            const DVec3 target = a + (random.below(2) == 0 ? 0.0 : random.uniform(0, 1)) * (b - a);
            const DVec3 origin = random.inCube(0.3);
            lines += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", place.x + origin.x,
                                 place.y + origin.y, place.z + origin.z, target.x - origin.x,
                                 target.y - origin.y, target.z - origin.z);
        }
        for (const Answer& a : parsed(answersOf(scene, lines))) {
            ASSERT_TRUE(a.hit) << place.x;
            ASSERT_NEAR(a.t, 1, 1e-5) << place.x;
        }
    }
}

TEST(HitLines, OfASceneFarAwayAreThoseOfTheSameSceneHere) {
    const DVec3 far(1 << 20, -(1 << 18), 1 << 19); // exact sums
    Scene here = underSky(Color(0));
    add(here, makeKnot({.triangles = 500}), matte(Color(1)));
    Scene there = here;
    there.objects[0].transform = at(far);
    Random random(6);
    std::string near, moved;
    for (int i = 0; i < 2000; ++i) {
        const DVec3 origin = glm::round(random.inCube(2) * 1024.0) / 1024.0, d = random.direction();
        near += lineOf(origin, d);
        const DVec3 o = origin + far;
        moved += fmt::format("{:.17g} {:.17g} {:.17g} {:.9g} {:.9g} {:.9g}\n", o.x, o.y, o.z, d.x, d.y, d.z);
    }
    const auto a = parsed(answersOf(here, near)), b = parsed(answersOf(there, moved));
    int other = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].hit != b[i].hit || a[i].id != b[i].id)
            ++other;
        else
            ASSERT_NEAR(a[i].t, b[i].t, 1e-5);
    }
    EXPECT_LE(other, 1);
}

TEST(HitLines, OfSpawnedRaysFindNoneThatMeetsItsOwnSurface) {
    Scene scene = underSky(Color(0));
    Random random(7);
    for (const double size : {1e-3, 1.0, 1e3}) {
        add(scene, Sphere{0.5F}, matte(Color(1)), cases::randomPlacement(random, size));
        add(scene, Box{Vec3(1)}, matte(Color(1)), cases::randomPlacement(random, size));
        add(scene, Cylinder{1, 0.2F, 0.5F}, matte(Color(1)), cases::randomPlacement(random, size));
        add(scene, cases::closedMesh(8, 12, 0.5), matte(Color(1)), cases::randomPlacement(random, size));
    }
    std::string lines;
    for (int i = 0; i < 20'000; ++i) {
        const DMat4& place = random.oneOf(scene.objects).transform;
        const DVec3 target = transformPoint(place, random.inCube(0.3));
        const DVec3 origin = target + random.uniform(1, 1000) * transformVector(place, random.direction());
        lines += lineOf(origin, target - origin);
    }
    const std::string answers = answersOf(scene, lines, HitQuestion::Spawned);
    EXPECT_EQ(answers.find('1'), std::string::npos);
    EXPECT_GT(std::count(answers.begin(), answers.end(), '0'), 20'000);
}

TEST(HitLines, OfSpawnedRaysTellWhereThereIsNone) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, matte(Color(1)));
    const auto spawned = [&](const char* line) { return answersOf(scene, line, HitQuestion::Spawned); };
    EXPECT_EQ(spawned("0 0 3 0 0 -1"), "0 0\n");
    EXPECT_EQ(spawned("0 0 3 0 1 0"), "- -\n") << "nothing is hit";
    EXPECT_EQ(spawned("0 0.9 0 0 0 -1"), "0 -\n") << "64 degrees inside glass: total reflection";
    EXPECT_EQ(spawned("0 0.6 0 0 0 -1"), "0 0\n") << "37 degrees";
}

TEST(HitLines, SkipBlankLinesAndComments) {
    Scene scene = underSky(Color(0));
    add(scene, Sphere{1}, matte(Color(1)), at({0, 0, -3}));
    EXPECT_EQ(answersOf(scene, "# rays\n\n  \t\r\n0 0 0 0 0 -1\r\n # 1 2 3\n\t0  0\t0 0 0 -1  \n0 0 0 0 1 0"),
              "2 0 0 0 1\n2 0 0 0 1\nmiss\n");
    EXPECT_EQ(answersOf(scene, ""), "");
}

TEST(HitLines, ThatAreNoRaysAreRefusedByTheirNumber) {
    for (const char* line : {"1 2 3",
                             "1 2 3 4 5",
                             "0 0 0 0 0 1 0",
                             "0 0 0 0 0 1 0 1 2",
                             "a b c d e f",
                             "0 0 0 0 0 1x",
                             "0 0 0 0 0 nan",
                             "nan 0 0 0 0 1",
                             "inf 0 0 0 0 1",
                             "0 0 0 0 0 inf",
                             "0 0 0 0 0 0",
                             "0 0 0 -0 0 0",
                             "0 0 0 0 0 1 -1 5",
                             "0 0 0 0 0 1 nan 5",
                             "0 0 0 0 0 1 0 nan",
                             "0 0 0 0 0 1 inf inf",
                             "1e16 0 0 0 0 1",
                             "1e999 0 0 0 0 1",
                             "0,0,0,0,0,1",
                             "0 0 0 0 0 0x1",
                             "0 0 0 0 0 1 # up"})
        try {
            parseRayLine(line, 17);
            ADD_FAILURE() << line;
        } catch (const InputError& error) {
            EXPECT_EQ(error.where(), "rays: line 17") << line;
        }
    const Scene scene = underSky(Color(0));
    const HitLines hits(buildWorld(std::make_shared<const Scene>(scene), {}), HitQuestion::Any);
    std::string answers;
    EXPECT_THROW(hits.answer("0 0 0 0 0 1\n0 0 0 0 0 1\nwrong\n0 0 0 0 0 1\n", 1, answers), InputError);
    EXPECT_EQ(answers, "0\n0\n") << "those before it are answered";
}

}
}
