// labels: unit
// The formulas as taught agree with the renderer's where nothing is hard: so what they do elsewhere is the
// formula's failure, not a slip in writing it down.

#include <gtest/gtest.h>

#include "core/geometry/textbook_box.h"
#include "core/geometry/textbook_plane.h"
#include "core/geometry/textbook_slab.h"
#include "core/geometry/textbook_spawn.h"
#include "core/geometry/textbook_sphere.h"
#include "core/geometry/textbook_transform.h"
#include "core/geometry/textbook_triangle.h"
#include "core/transport/optics.h"
#include "core/transport/textbook_optics.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using cases::Random;
using cases::ray;

template <class T>
class TextbookIn : public testing::Test {};
using Scalars = testing::Types<float, double>;
TYPED_TEST_SUITE(TextbookIn, Scalars);

Ray towardsTheMiddle(Random& random) {
    const DVec3 origin = 3.0 * random.direction();
    return ray(origin, glm::normalize(random.inCube(0.9) - origin));
}

TYPED_TEST(TextbookIn, HitsASphereNearby) {
    Random random(1);
    int hits = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Ray ray = towardsTheMiddle(random);
        const auto taught = textbook::intersectSphere<TypeParam>(1, textbook::RayOf<TypeParam>(ray));
        const auto hit = intersect(Sphere{1}, ray);
        const double aside = glm::length(glm::cross(DVec3(ray.origin), DVec3(ray.direction)));
        if (std::fabs(aside - 1) < 1e-3) continue;
        ASSERT_EQ(taught.has_value(), hit.has_value());
        if (!hit) continue;
        ASSERT_NEAR(*taught, hit->t, 1e-4);
        ++hits;
    }
    EXPECT_GT(hits, 5000);
}

TYPED_TEST(TextbookIn, HitsATriangleAwayFromItsEdges) {
    Random random(2);
    int hits = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Ray ray = towardsTheMiddle(random);
        textbook::Corners<TypeParam> corners;
        TriangleCorners same;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 p(random.inCube(1));
            corners[k] = textbook::Vector<TypeParam>(p);
            same[k] = toArray(p);
        }
        const auto taught = textbook::intersectTriangle<TypeParam>(
            corners, textbook::RayOf<TypeParam>(ray), TypeParam(textbook::kMollerTrumboreEpsilon));
        const auto hit = intersectCorners(same, true, RayShear(ray), ray.tMin, ray.tMax);
        const auto atAnEdge = [](double u, double v) { return std::min({u, v, 1 - u - v}) < 1e-3; };
        if ((taught && atAnEdge(taught->u, taught->v)) || (hit && atAnEdge(hit->u, hit->v))) continue;
        ASSERT_EQ(taught.has_value(), hit.has_value());
        if (!hit) continue;
        ASSERT_NEAR(taught->t, hit->t, 1e-3);
        ASSERT_NEAR(taught->u, hit->u, 1e-2);
        ++hits;
    }
    EXPECT_GT(hits, 500);
}

TYPED_TEST(TextbookIn, MeetsBoxesAndPlanes) {
    Random random(3);
    int met = 0;
    for (int i = 0; i < 10'000; ++i) {
        const Ray ray = towardsTheMiddle(random);
        const textbook::RayOf<TypeParam> same(ray);
        const Vec3 size(random.inCube(0.7) + DVec3(0.8));
        const textbook::Vector<TypeParam> half = TypeParam(0.5) * textbook::Vector<TypeParam>(size);
        const auto hit = intersect(Box{size}, ray);
        ASSERT_EQ(textbook::meetsSlabs<TypeParam>(-half, half, same), hit.has_value());
        ASSERT_EQ(textbook::meetsThickSlabs<TypeParam>(-half, half, same), hit.has_value());
        if (hit) {
            const auto normal = textbook::boxNormal<TypeParam>(same.at(hit->t), half, TypeParam(1e-4));
            if (glm::length(normal) == 1) {
                ASSERT_EQ(Vec3(normal), surfaceAt(Box{size}, ray, *hit).geometricNormal);
            }
        }
        const auto plane = intersect(Plane{kInfinity, kInfinity, true}, ray);
        const auto taught = textbook::intersectPlane<TypeParam>({0, 1, 0}, 0, same);
        ASSERT_EQ(taught.has_value(), plane.has_value());
        if (plane) {
            ASSERT_NEAR(*taught / plane->t, 1, 1e-5);
        }
        met += hit ? 1 : 0;
    }
    EXPECT_GT(met, 3000);
}

TYPED_TEST(TextbookIn, BendsRaysIntoTheDenserMedium) {
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 normal(random.direction()), wo(random.direction());
        if (glm::dot(normal, wo) < 0.01F) continue;
        const auto bent = refracted(wo, normal, 1 / 1.5F);
        ASSERT_TRUE(bent);
        const textbook::Vector<TypeParam> n(normal), w(wo);
        const auto taught = textbook::refracted<TypeParam>(w, n, TypeParam(1 / 1.5F));
        ASSERT_LT(glm::length(Vec3(taught) - *bent), 1e-5);
    }
}

TEST(Textbook, RefractionIsNotANumberBeyondTheCriticalAngle) {
    const Vec3 wo = glm::normalize(Vec3(1, 1, 0));
    EXPECT_TRUE(std::isnan(textbook::refracted<float>(wo, {0, 1, 0}, 1.5F).y));
}

TEST(Textbook, MirrorWithTheWrongSignIsTooLong) {
    const Vec3 wo = glm::normalize(Vec3(1, 1, 0));
    EXPECT_NEAR(glm::length(textbook::reflected<float>(wo, {0, 1, 0})), std::sqrt(5), 1e-6);
}

TEST(Textbook, SchlickIsOffBySoMuch) {
    EXPECT_NEAR(textbook::schlick<double>(std::cos(radians(45)), 1 / 1.5), 0.042069, 1e-6);
    EXPECT_NEAR(textbook::schlick<double>(0.5, 1 / 1.5), 0.070000, 1e-6);
    EXPECT_NEAR(textbook::schlick<double>(std::cos(radians(40)), 1.5), 0.040673, 1e-6);
}

TEST(Textbook, NormalByTheMatrixOfThePointsIsOffBySoMuch) {
    const DVec3 normal = glm::normalize(DVec3(0, 1, 1));
    const DMat3 squash(1, 0, 0, 0, 1, 0, 0, 0, 0.1);
    const DVec3 truth = glm::normalize(glm::transpose(glm::inverse(squash)) * normal);
    EXPECT_NEAR(degrees(std::acos(glm::dot(textbook::toWorldNormal<double>(squash, normal), truth))), 78.58,
                0.005);
}

TEST(Textbook, RenormalisedDirectionMeasuresInUnitsOfTheObject) {
    const DMat4 tenfold(10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 1);
    const textbook::RayOf<double> ray({0, 0, 5}, {0, 0, -1});
    EXPECT_DOUBLE_EQ(*textbook::intersectSphere<double>(1, textbook::toObject<double>(tenfold, ray)), 49);
}

TEST(Textbook, OffsetByUlpsMovesOutward) {
    Random random(5);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 point(random.inCube(std::pow(10, random.uniform(-3, 5)))), normal(random.direction());
        for (const float side : {1.0F, -1.0F}) {
            const Vec3 moved = textbook::spawnOriginByUlps(point, normal, side * normal) - point;
            ASSERT_GT(side * glm::dot(moved, normal), 0);
            ASSERT_LT(glm::length(moved), 1e-4F * (1 + glm::length(point)));
        }
    }
}

}
}
