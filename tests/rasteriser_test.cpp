// labels: ui
// What OpenGL draws of a scene against what the tracer finds at the centre of each pixel.

#include <gtest/gtest.h>

#include "app/document/document.h"
#include "app/document/scene_files.h"
#include "app/platform/headless_platform.h"
#include "app/rayview/rasteriser.h"
#include "core/transport/integrator.h"

namespace eyeray {
namespace {

constexpr int kWidth = 192, kHeight = 144;

TraceSettings methodOnly(Method method) {
    TraceSettings settings;
    settings.method = method;
    return settings;
}

/// A scene drawn and traced, pixel by pixel.
struct Both {
    explicit Both(const std::string& name, int width = kWidth, int height = kHeight)
        : document(openScene(name).document), world(buildWorld(document.scene, {})),
          context(world, document.camera, methodOnly(Method::Local), width, height, 0, {}),
          drawn(Rasteriser(platform.gl()).draw(world, document.camera, width, height)) {
        const auto local = makeIntegrator(Method::Local);
        const DVec3 forward = -axesOf(document.camera).backward;
        objects = Pixels<int>(width, height, -1);
        distance = Pixels<float>(width, height, kInfinity);
        radiance = ColorImage(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Retrace trace = local->retrace(context, x, y, 0);
                const RayRecord& eye = trace.rays.front();
                objects.at(x, y) = eye.object;
                if (eye.end == RayEnd::Hit)
                    distance.at(x, y) = static_cast<float>(eye.t * glm::dot(forward, DVec3(eye.direction)));
                radiance.at(x, y) = trace.radiance;
            }
    }

    /// Another object, or another part of it far before or behind, is seen within a pixel.
    bool edge(int x, int y) const {
        for (int v = std::max(0, y - 1); v <= std::min(y + 1, distance.height() - 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(x + 1, distance.width() - 1); ++u) {
                if (objects.at(u, v) != objects.at(x, y)) return true;
                const float a = distance.at(u, v), b = distance.at(x, y);
                if (std::isfinite(a) != std::isfinite(b)) return true;
                if (std::isfinite(a) && std::fabs(a - b) > 0.02F * b) return true;
            }
        return false;
    }

    template <class Visit>
    void eachInnerPixel(const Visit& visit) const {
        for (int y = 0; y < distance.height(); ++y)
            for (int x = 0; x < distance.width(); ++x)
                if (!edge(x, y)) visit(x, y);
    }

    HeadlessPlatform platform{8, 8};
    Document document;
    std::shared_ptr<const World> world;
    TraceContext context;
    RasterPicture drawn;
    Pixels<int> objects;
    Pixels<float> distance;
    ColorImage radiance;
};

class RasteriserOfMeshes : public testing::TestWithParam<const char*> {};

TEST_P(RasteriserOfMeshes, FindsTheObjectsOfTheTracerButForPixelsAtEdges) {
    const Both both(GetParam());
    int different = 0, inner = 0;
    both.eachInnerPixel([&](int x, int y) {
        ++inner;
        EXPECT_EQ(both.drawn.objects.at(x, y), both.objects.at(x, y)) << x << ' ' << y;
    });
    for (std::size_t i = 0; i < both.objects.values().size(); ++i)
        different += both.objects.values()[i] != both.drawn.objects.values()[i];
    EXPECT_GT(inner, kWidth * kHeight / 2);
    EXPECT_LE(different, kWidth * kHeight / 500) << "at edges a float decides";
}

TEST_P(RasteriserOfMeshes, HasTheTracersDistancesInItsDepthBuffer) {
    const Both both(GetParam());
    both.eachInnerPixel([&](int x, int y) {
        const float traced = both.distance.at(x, y), drawn = both.drawn.distance.at(x, y);
        if (!std::isfinite(traced)) {
            EXPECT_FALSE(std::isfinite(drawn)) << x << ' ' << y;
            return;
        }
        EXPECT_NEAR(drawn, traced, 1e-3F * traced) << x << ' ' << y;
    });
}

TEST_P(RasteriserOfMeshes, ShadesAsTheMethodLocal) {
    const Both both(GetParam());
    int inner = 0, far = 0;
    both.eachInnerPixel([&](int x, int y) {
        ++inner;
        const Color a = both.drawn.radiance.at(x, y), b = both.radiance.at(x, y);
        far += maxComponent(glm::abs(a - b)) > 0.01F + 0.03F * maxComponent(b);
    });
    EXPECT_LE(far, inner / 100);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RasteriserOfMeshes, testing::Values("knot", "terrain", "prism", "cornell"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(Rasteriser, DrawsShapesNearlyAsTheTracerSeesThem) {
    for (const char* name : {"phong", "primitives", "falloff", "window"}) {
        const Both both(name);
        int different = 0, far = 0;
        for (std::size_t i = 0; i < both.objects.values().size(); ++i) {
            different += both.objects.values()[i] != both.drawn.objects.values()[i];
            const Color a = both.drawn.radiance.values()[i], b = both.radiance.values()[i];
            far += maxComponent(glm::abs(a - b)) > 0.02F + 0.05F * maxComponent(b);
        }
        EXPECT_LT(different, kWidth * kHeight / 50) << name;
        EXPECT_LT(far, kWidth * kHeight / 25) << name;
    }
}

TEST(Rasteriser, KnowsNoShadows) {
    const Both both("shadows");
    const TraceContext withShadows(both.world, both.document.camera, methodOnly(Method::Cast), kWidth,
                                   kHeight, 0, {});
    const auto cast = makeIntegrator(Method::Cast);
    int shadowed = 0;
    both.eachInnerPixel([&](int x, int y) {
        const Retrace trace = cast->retrace(withShadows, x, y, 0);
        const bool blocked = std::any_of(trace.rays.begin(), trace.rays.end(),
                                         [](const RayRecord& ray) { return ray.end == RayEnd::Blocked; });
        if (!blocked) return;
        ++shadowed;
        EXPECT_GT(luminance(both.drawn.radiance.at(x, y)), luminance(trace.radiance));
    });
    EXPECT_GT(shadowed, 500);
}

}
}
