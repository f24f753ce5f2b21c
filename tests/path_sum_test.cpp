// labels: unit
// The flat list of what a path's light comes from.

#include <random>

#include <gtest/gtest.h>

#include "core/scene/gltf.h"
#include "core/study/path_sum.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

TraceSettings by(Method method) {
    TraceSettings settings = toDepth(5);
    settings.method = method;
    return settings;
}

TEST(PathSum, AddsUpToTheSampleOfEveryPhysicalMethod) {
    constexpr int kWidth = 96, kHeight = 54, kPixels = 150;
    std::mt19937 random(1);
    for (const char* name : {"cornell", "metals", "window", "homage"}) {
        ImportReport report;
        const std::string file = std::string(EYERAY_SOURCE_DIR "/assets/scenes/") + name + ".gltf";
        const auto world = buildWorld(std::make_shared<const Scene>(importGltf(file, report)), {});
        for (const Method method : {Method::Distributed, Method::Path}) {
            const Tracing tracing(world, by(method), kWidth, kHeight);
            std::size_t longest = 0;
            for (int i = 0; i < kPixels; ++i) {
                const Retrace trace = tracing.retrace(static_cast<int>(random() % kWidth),
                                                      static_cast<int>(random() % kHeight), i % 7);
                const auto terms = pathTermsOf(trace);
                const DVec3 difference = sumOf(terms) - DVec3(trace.radiance);
                ASSERT_LE(glm::length(difference), 1e-5 * (1 + glm::length(DVec3(trace.radiance))))
                    << name << ", sample " << i % 7;
                longest = std::max(longest, terms.size());
            }
            EXPECT_GE(longest, method == Method::Path ? 4U : 1U) << name;
        }
    }
}

TEST(PathSum, NamesTheFactorsOfALampOverAFloor) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{10, 10}, matte(Color(0.6F, 0.3F, 0.2F)));
    scene.lights.push_back(lampAt({0, 2, 0}, PointLamp{}, 10));
    look(scene, {3, 3, 0.01}, {1, 0, 0});
    const auto terms = pathTermsOf(Tracing(scene, by(Method::Path)).retrace());
    ASSERT_EQ(terms.size(), 1U);
    const PathTerm& term = terms.front();
    EXPECT_EQ(term.source, PathTerm::Source::DiffuseLight);
    EXPECT_EQ(term.throughput, Color(1));
    EXPECT_NEAR(term.scattered.r, 0.6 / kPiD * 2 / std::sqrt(5.0), 1e-6);
    EXPECT_NEAR(term.radiance.r, 10.0 / 5, 1e-5) << "irradiance of the lamp at the floor";
    EXPECT_EQ(term.pdfW, 0);
    EXPECT_EQ(term.mis, 1);
    EXPECT_EQ(term.visibility, Color(1));
}

// Both ways to a lamp with an extent find its radiance, and the weights of both are of one heuristic.
TEST(PathSum, GivesTheRadianceOfALampByBothWays) {
    Scene scene = underSky(Color(0));
    add(scene, Plane{10, 10}, matte(Color(0.5F)));
    scene.lights.push_back(lampAt({0, 1, 0}, RectangleLamp{3, 3}, 7));
    look(scene, {0, 0.5, 0.01}, {0, 0, 0});
    const Tracing tracing(scene, by(Method::Path));
    int sampled = 0, found = 0;
    for (int pass = 0; pass < 64; ++pass)
        for (const PathTerm& term : pathTermsOf(tracing.retrace(0, 0, pass))) {
            EXPECT_NEAR(term.radiance.g, 7, 1e-4);
            EXPECT_GT(term.mis, 0);
            EXPECT_LT(term.mis, 1);
            ++(term.lamp >= 0 ? sampled : found);
        }
    EXPECT_GT(sampled, 0);
    EXPECT_GT(found, 0);
}

TEST(PathSum, IsEmptyForTheTaughtMethods) {
    Scene scene = underSky(Color(1));
    add(scene, Sphere{1}, matte(Color(1)));
    look(scene, {0, 0, 5}, {0, 0, 0});
    EXPECT_TRUE(pathTermsOf(Tracing(scene).retrace()).empty());
}

}
}
