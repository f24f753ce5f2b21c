// labels: unit
// Boxes.

#include <gtest/gtest.h>

#include "core/geometry/shapes.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;

TEST(Box, EveryFaceIsHitHeadOnAndNamedInOrder) {
    const Box box{Vec3(2, 4, 6)};
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double side = face % 2 == 1 ? 1 : -1;
        DVec3 out(0);
        out[axis] = side;
        const Ray inward = ray(10.0 * out, -out), outward = ray(DVec3(0), out);
        for (const Ray& r : {inward, outward}) {
            const auto hit = intersect(box, r);
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->primitive, static_cast<std::uint32_t>(face));
            const SurfacePoint point = surfaceAt(box, r, *hit);
            EXPECT_EQ(point.geometricNormal, Vec3(out));
            EXPECT_EQ(point.position, Vec3(0.5 * static_cast<double>(box.size[axis]) * out));
        }
        EXPECT_EQ(intersect(box, inward)->t, 10 - box.size[axis] / 2);
        EXPECT_EQ(intersect(box, outward)->t, box.size[axis] / 2);
        EXPECT_FALSE(intersect(box, ray(10.0 * out, out))) << "behind";
    }
}

TEST(Box, RayAlongAFaceOrAnEdgeTouches) {
    const Box box{Vec3(2)};
    EXPECT_EQ(intersect(box, ray({5, 1, 0}, {-1, 0, 0}))->t, 4);
    EXPECT_EQ(intersect(box, ray({5, 1, -1}, {-1, 0, 0}))->t, 4);
    EXPECT_EQ(intersect(box, ray({5, 1, -1}, {-1, -0.0, 0.0}))->t, 4);
    EXPECT_FALSE(intersect(box, ray({5, std::nextafter(1.0F, 2.0F), 0}, {-1, 0, 0})));
    EXPECT_FALSE(intersect(box, ray({5, 2, 0}, {-1, -0.0, 0})));
}

TEST(Box, LimitsOfTheRayAreExclusive) {
    const Box box{Vec3(2)};
    const Vec3 o(5, 0, 0), d(-1, 0, 0);
    EXPECT_FALSE(intersect(box, Ray{o, d, 0, 4}));
    EXPECT_EQ(intersect(box, Ray{o, d, 4, kInfinity})->t, 6) << "the far side";
    EXPECT_FALSE(intersect(box, Ray{o, d, 6, kInfinity}));
}

TEST(Box, FlatOneIsHit) {
    const Box flat{Vec3(2, 0, 2)};
    const auto hit = intersect(flat, ray({0.3, 5, 0.3}, {0, -1, 0}));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->t, 5);
    EXPECT_EQ(hit->primitive, 3U);
}

TEST(Box, NothingIsHitByARayThatIsNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(intersect(Box{}, ray({0, 0, 0}, {0, 0, 0})));
    EXPECT_FALSE(intersect(Box{}, ray({0, nan, 5}, {0, 0, -1})));
    EXPECT_FALSE(intersect(Box{}, ray({0, 0, 5}, {nan, 0, -1})));
    EXPECT_FALSE(intersect(Box{Vec3(1, std::nanf(""), 1)}, ray({0, 0, 5}, {0, 0, -1})));
    EXPECT_FALSE(intersect(Box{Vec3(1, -1, 1)}, ray({0, 0, 5}, {0, 0, -1})));
}

// The largest of the three entries (or the least of the exits) in long double names the face: stability F15.
TEST(Box, FaceIsTheOneThatLongDoubleNamesAtAllScales) {
    using Real = long double;
    Random random(1);
    for (const double scale : {1e-3, 1.0, 1e3, 1e5}) {
        int hits = 0;
        for (int i = 0; i < 50'000; ++i) {
            const Box box{Vec3(scale * DVec3(random.uniform(0.5, 2), random.uniform(0.5, 2), 1.0))};
            const bool inside = i % 2 == 0;
            const Ray r = ray(random.inCube(scale * (inside ? 0.2 : 4.0)), random.direction());
            Real in = -1e30L, out = 1e30L, secondIn = in, secondOut = out;
            std::uint32_t inFace = 0, outFace = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const Real o = r.origin[axis], d = r.direction[axis], half = 0.5L * box.size[axis];
                const Real a = std::fmin((-half - o) / d, (half - o) / d);
                const Real b = std::fmax((-half - o) / d, (half - o) / d);
                const auto face = static_cast<std::uint32_t>(2 * axis);
                secondIn = std::fmax(secondIn, std::fmin(a, in));
                secondOut = std::fmin(secondOut, std::fmax(b, out));
                if (a > in) inFace = face + (d > 0 ? 0U : 1U);
                if (b < out) outFace = face + (d > 0 ? 1U : 0U);
                in = std::fmax(in, a);
                out = std::fmin(out, b);
            }
            if (std::fabs(out - in) < 1e-9L * scale || in - secondIn < 1e-9L * scale ||
                secondOut - out < 1e-9L * scale)
                continue; // an edge: either face will do
            const auto hit = intersect(box, r);
            ASSERT_EQ(hit.has_value(), in <= out && out > 0);
            if (!hit) continue;
            ++hits;
            ASSERT_EQ(hit->primitive, in > 0 ? inFace : outFace);
            ASSERT_NEAR(static_cast<double>(hit->t / (in > 0 ? in : out)), 1, 6e-8);
        }
        EXPECT_GT(hits, 25'000) << scale;
    }
}

}
}
