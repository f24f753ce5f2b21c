// labels: unit
// The test of a ray against a box that indices cull by may say yes in doubt, never no (stability F12 to F14).

#include <gtest/gtest.h>

#include "core/geometry/slab.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;
using Real = long double;

bool enters(const Bounds& box, const Ray& r, float limit = kInfinity) {
    const RaySlab slab(r, box);
    return slab.enter({{{box.lo.x, box.lo.y, box.lo.z}, {box.hi.x, box.hi.y, box.hi.z}}}, limit) < kInfinity;
}

// Exact for small integers: parallel axes apart, all else in long double.
bool touches(const Bounds& box, const Ray& r) {
    Real in = r.tMin, out = r.tMax;
    for (int axis = 0; axis < 3; ++axis) {
        const Real o = r.origin[axis], d = r.direction[axis], lo = box.lo[axis], hi = box.hi[axis];
        if (d == 0) {
            if (o < lo || o > hi) return false;
            continue;
        }
        in = std::fmax(in, std::fmin((lo - o) / d, (hi - o) / d));
        out = std::fmin(out, std::fmax((lo - o) / d, (hi - o) / d));
    }
    return in <= out;
}

TEST(RaySlab, AgreesWithTheExactTestOnAllOriginsAndDirectionsOfALattice) {
    const Bounds cube{Vec3(-1), Vec3(1)}, flat{Vec3(-1, 0, -1), Vec3(1, 0, 1)}, point{Vec3(0), Vec3(0)};
    int tests = 0;
    for (const Bounds& box : {cube, flat, point})
        for (int o = 0; o < 125; ++o)
            for (int d = 0; d < 64; ++d) {
                const auto component = [&](int digit) { // −1, −0, +0, 1
                    return std::array{-1.0F, -0.0F, 0.0F, 1.0F}[static_cast<std::size_t>(digit)];
                };
                const Ray r{.origin = Vec3(o % 5 - 2, o / 5 % 5 - 2, o / 25 - 2),
                            .direction = Vec3(component(d % 4), component(d / 4 % 4), component(d / 16))};
                if (r.direction == Vec3(0)) continue;
                ASSERT_EQ(enters(box, r), touches(box, r)) << o << " " << d;
                ++tests;
            }
    EXPECT_EQ(tests, 3 * 125 * (64 - 8));
}

TEST(RaySlab, FlatBoxIsNeverMissed) {
    Random random(1);
    for (int i = 0; i < 200'000; ++i) {
        const int axis = i % 3;
        DVec3 lo = random.inCube(10) - DVec3(1), hi = lo + DVec3(2);
        hi[axis] = lo[axis];
        const Bounds box{Vec3(lo), Vec3(hi)};
        DVec3 target(random.uniform(box.lo.x, box.hi.x), random.uniform(box.lo.y, box.hi.y),
                     random.uniform(box.lo.z, box.hi.z));
        target[axis] = box.lo[axis];
        const DVec3 origin = random.inCube(20);
        ASSERT_TRUE(enters(box, ray(origin, target - DVec3(Vec3(origin)))));
    }
}

TEST(RaySlab, RayThatTouchesAnEdgeIsNotRejected) {
    Random random(2);
    int touching = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const DVec3 lo = random.inCube(1), hi = lo + DVec3(random.uniform(0.01, 1));
        const Bounds box{Vec3(lo), Vec3(hi)};
        DVec3 onEdge(random.below(2) == 0 ? box.lo.x : box.hi.x, random.below(2) == 0 ? box.lo.y : box.hi.y,
                     random.below(2) == 0 ? box.lo.z : box.hi.z);
        const int along = random.below(3);
        onEdge[along] = random.uniform(box.lo[along], box.hi[along]);
        const DVec3 origin = random.inCube(5);
        const Ray r = ray(origin, onEdge - DVec3(Vec3(origin)));
        if (!touches(box, r)) continue;
        ++touching;
        ASSERT_TRUE(enters(box, r));
    }
    EXPECT_GT(touching, 300'000);
}

TEST(RaySlab, RayThatMissesClearlyIsRejected) {
    Random random(3);
    int misses = 0;
    for (int i = 0; i < 100'000; ++i) {
        const DVec3 lo = random.inCube(1), hi = lo + DVec3(random.uniform(0.01, 1));
        const Bounds box{Vec3(lo), Vec3(hi)}, wider{Vec3(lo - DVec3(1e-4)), Vec3(hi + DVec3(1e-4))};
        const Ray r = ray(random.inCube(5), random.direction());
        if (touches(wider, r)) continue;
        ++misses;
        ASSERT_FALSE(enters(box, r));
    }
    EXPECT_GT(misses, 50'000);
}

TEST(RaySlab, BoxBeyondTheLimitOrBehindIsRejected) {
    const Bounds box{Vec3(-1), Vec3(1)};
    const Ray r = ray({0, 0, 5}, {0, 0, -1});
    EXPECT_TRUE(enters(box, r, 4.01F));
    EXPECT_FALSE(enters(box, r, 3.99F));
    EXPECT_FALSE(enters(box, ray({0, 0, 5}, {0, 0, 1})));
    EXPECT_FALSE(enters(box, Ray{r.origin, r.direction, 6.01F, kInfinity}));
    EXPECT_TRUE(enters(box, Ray{r.origin, r.direction, 5.99F, kInfinity}));
}

TEST(RaySlab, EntryIsWhereTheBoxBegins) {
    const std::array<std::array<float, 3>, 2> corners{{{-1, -1, -1}, {1, 1, 1}}};
    const Bounds box{Vec3(-1), Vec3(1)};
    // Boxes grow by 16 units of 2⁻²⁴ of the way to their farthest side, 6, where the ray enters by 16 more.
    EXPECT_NEAR(RaySlab(ray({0, 0, 5}, {0, 0, -1}), box).enter(corners, kInfinity), 4, 36 * 0x1p-24 * 6);
    EXPECT_EQ(RaySlab(ray({0, 0, 0}, {0, 0, -1}), box).enter(corners, kInfinity), 0) << "inside";
}

}
}
