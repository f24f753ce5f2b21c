// labels: unit
// Mirror and glass against closed forms in long double (stability F27 to F31, 2.5).

#include <gtest/gtest.h>

#include "core/transport/optics.h"
#include "tests/geometry_cases.h"

namespace eyeray {
namespace {

using Real = long double;
constexpr Real kDegree = 3.14159265358979323846264338L / 180;
const Vec3 kUp(0, 0, 1);

Vec3 fromAngle(double degrees) { return Vec3(std::sin(radians(degrees)), 0, std::cos(radians(degrees))); }

/// Fresnel's equations in the form with angles, sin²(i − t)/sin²(i + t) and tan²(i − t)/tan²(i + t).
Real fresnelByAngles(Real incident, Real eta) {
    const Real sine = eta * std::sin(incident);
    if (sine >= 1) return 1;
    if (incident == 0) return (eta - 1) * (eta - 1) / ((eta + 1) * (eta + 1));
    const Real refracted = std::asin(sine), difference = incident - refracted, sum = incident + refracted;
    const auto squared = [](Real x) { return x * x; };
    return (squared(std::sin(difference) / std::sin(sum)) + squared(std::tan(difference) / std::tan(sum))) /
           2;
}

float fresnelAt(double degrees, double eta) {
    return fresnelDielectric(static_cast<float>(std::cos(radians(degrees))), static_cast<float>(eta));
}

TEST(Reflected, KeepsTheAngleLengthAndPlane) {
    cases::Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 n(random.direction()), l(random.direction());
        const Vec3 r = reflected(l, n);
        EXPECT_NEAR(glm::dot(r, n), glm::dot(l, n), 1e-6);
        EXPECT_NEAR(glm::length(r), 1, 1e-6);
        EXPECT_NEAR(glm::dot(glm::cross(l, n), r), 0, 1e-6);
        EXPECT_NEAR(glm::length(reflected(r, n) - l), 0, 2e-6) << "twice is back";
    }
}

TEST(Refracted, FollowsSnellsLaw) {
    cases::Random random(2);
    for (int i = 0; i < 100'000; ++i) {
        const Vec3 n(random.direction());
        Vec3 wo(random.direction());
        if (glm::dot(n, wo) < 0) wo = -wo;
        const auto eta = static_cast<float>(random.uniform(0.4, 2.5));
        const double sineIn = glm::length(glm::cross(DVec3(n), DVec3(wo)));
        const auto direction = refracted(wo, n, eta);
        if (!direction) {
            EXPECT_GT(eta * sineIn, 1 - 1e-6);
            continue;
        }
        const DVec3 d(*direction);
        EXPECT_NEAR(glm::length(d), 1, 1e-6);
        EXPECT_LT(glm::dot(d, DVec3(n)), 0) << "to the other side";
        EXPECT_NEAR(glm::length(glm::cross(DVec3(n), d)), eta * sineIn, 1e-6);
        EXPECT_NEAR(glm::dot(glm::cross(DVec3(wo), DVec3(n)), d), 0, 1e-6) << "in the plane of incidence";
        EXPECT_GT(glm::dot(-DVec3(wo), d), 0) << "forward";
    }
}

TEST(Refracted, RayLeavesASlabParallelToHowItCame) {
    cases::Random random(3);
    for (int i = 0; i < 10'000; ++i) {
        const Vec3 wo = fromAngle(random.uniform(0, 89));
        const auto eta = static_cast<float>(random.uniform(1, 2.5));
        const auto inside = refracted(wo, kUp, 1 / eta);
        ASSERT_TRUE(inside);
        const auto outside = refracted(-*inside, kUp, eta);
        ASSERT_TRUE(outside);
        EXPECT_LT(glm::length(*outside + wo), 2e-6F / wo.z);
    }
}

TEST(Refracted, TotalReflectionSetsInAtTheCriticalAngle) {
    struct Glass {
        double ior, critical; // degrees
    };
    for (const Glass& glass : {Glass{1.33, 48.753467}, {1.49, 42.155}, {1.5, 41.810315}, {2.42, 24.407469}}) {
        double below = 0, above = 90;
        while (above - below > 1e-6) {
            const double middle = (below + above) / 2;
            (refracted(fromAngle(middle), kUp, static_cast<float>(glass.ior)) ? below : above) = middle;
        }
        EXPECT_NEAR(below, glass.critical, 0.01);
        EXPECT_EQ(fresnelAt(above + 0.01, glass.ior), 1.0F);
        EXPECT_LT(fresnelAt(below - 0.01, glass.ior), 1.0F);
    }
}

TEST(FresnelDielectric, HasTheValuesOfTheTable) {
    const double table[][3] = {// degrees, η of wo's side / η beyond, reflectance
                               {0, 1 / 1.5, 0.04},         {30, 1 / 1.5, 0.041522626},
                               {45, 1 / 1.5, 0.050239911}, {60, 1 / 1.5, 0.089186713},
                               {75, 1 / 1.5, 0.253060563}, {80, 1 / 1.5, 0.387704355},
                               {85, 1 / 1.5, 0.612799645}, {89, 1 / 1.5, 0.904184950},
                               {40, 1.5, 0.245291},        {60, 1.5, 1},
                               {0, 1 / 1.33, 0.0200593},   {0, 1 / 1.49, 0.0387252}};
    for (const auto& [degrees, eta, expected] : table) EXPECT_NEAR(fresnelAt(degrees, eta), expected, 1e-6);
}

TEST(FresnelDielectric, IsTheClosedFormAtEveryAngle) {
    for (const double ior : {1.0, 1.000277, 1.1, 1.33, 1.49, 1.52, 2.42})
        for (const auto eta : {static_cast<float>(ior), static_cast<float>(1 / ior)})
            for (double degrees = 0; degrees < 90; degrees += 0.01) {
                const auto cosine = static_cast<float>(std::cos(radians(degrees)));
                const Real exact = fresnelByAngles(std::acos(static_cast<Real>(cosine)), eta);
                ASSERT_NEAR(fresnelDielectric(cosine, eta), static_cast<double>(exact), 1e-6)
                    << degrees << "° " << eta;
            }
}

TEST(FresnelDielectric, IsTheSameFromBothSides) {
    for (double degrees = 0; degrees < 80; degrees += 0.5) {
        const double inside = std::asin(std::sin(radians(degrees)) / 1.5);
        EXPECT_NEAR(fresnelAt(eyeray::degrees(inside), 1.5), fresnelAt(degrees, 1 / 1.5), 1e-6) << degrees;
    }
}

double hemisphericalMean(double eta) {
    constexpr int kSteps = 200'000;
    double sum = 0; // ∫ R d(sin²θ)
    for (int i = 0; i < kSteps; ++i)
        sum += static_cast<double>(fresnelDielectric(static_cast<float>(std::sqrt(1 - (i + 0.5) / kSteps)),
                                                     static_cast<float>(eta)));
    return sum / kSteps;
}

TEST(FresnelDielectric, HasTheKnownHemisphericalMean) {
    EXPECT_NEAR(hemisphericalMean(1 / 1.5), 0.091777959, 1e-6);
    EXPECT_NEAR(hemisphericalMean(1 / 1.33), 0.065930849, 1e-6);
    EXPECT_NEAR(hemisphericalMean(1.5), 0.596345760, 5e-6);
}

TEST(FresnelDielectric, LosesOnePolarisationAtBrewstersAngle) {
    const Real brewster = std::atan(1.5L), inner = std::asin(std::sin(brewster) / 1.5L);
    const Real s = std::sin(brewster - inner) / std::sin(brewster + inner);
    EXPECT_NEAR(static_cast<double>(brewster / kDegree), 56.309932, 1e-6);
    EXPECT_NEAR(fresnelAt(56.309932, 1 / 1.5), static_cast<double>(s * s / 2), 1e-7);
}

TEST(TransmittanceOf, FollowsBeerAndLambert) {
    const Color t = transmittanceOf(Color(0.5F, 1, 5), 0.5F);
    EXPECT_NEAR(t.r, std::exp(-0.25), 1e-7);
    EXPECT_NEAR(t.g, 0.606530660, 1e-7);
    EXPECT_NEAR(t.b, 0.082084999, 1e-7);
}

TEST(TransmittanceOf, DoubledThicknessSquaresIt) {
    cases::Random random(4);
    for (int i = 0; i < 10'000; ++i) {
        const Color sigma(random.uniform(0, 3), random.uniform(0, 3), random.uniform(0, 3));
        const auto d = static_cast<float>(random.uniform(0, 3));
        const Color once = transmittanceOf(sigma, d), twice = transmittanceOf(sigma, 2 * d);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(twice[c], once[c] * once[c], 4e-7 * twice[c]);
    }
}

TEST(TransmittanceOf, ForeverIsDarkOnlyWhereSomethingAbsorbs) {
    EXPECT_EQ(transmittanceOf(Color(0, 0.1F, 10), kInfinity), Color(1, 0, 0));
    EXPECT_EQ(transmittanceOf(Color(0, 0.1F, 10), 0), Color(1));
}

}
}
