// labels: image
// What must hold of every built-in scene's picture whatever it shows (stability 1.4): other indices and
// threads, the scene moved, mirrored, its lamps one by one or twice as bright, its samples in parts.

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/render/render_session.h"
#include "core/scene/gltf.h"
#include "tests/geometry_cases.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

constexpr int kWidth = 64, kHeight = 36;

std::vector<std::filesystem::path> sceneFiles() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(EYERAY_SOURCE_DIR) / "assets/scenes"))
        files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

/// Pixels that differ by more than `relative` of the second, or of 1 where it is darker.
int different(const std::vector<Color>& a, const std::vector<Color>& b, float relative = 0) {
    EXPECT_EQ(a.size(), b.size());
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!isNear(a[i], b[i], relative * std::max(1.0F, maxComponent(b[i])))) ++count;
    return count;
}

std::vector<Color> scaled(std::vector<Color> picture, float factor) {
    for (Color& c : picture) c *= factor;
    return picture;
}

std::vector<Color> sum(std::vector<Color> a, const std::vector<Color>& b, float factor = 1) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
    return a;
}

Scene twiceAsBright(Scene scene) {
    for (Light& light : scene.lights) light.intensity *= 2;
    scene.ambient *= 2;
    for (Color* c : {&scene.environment.zenith, &scene.environment.horizon, &scene.environment.nadir})
        *c *= 2;
    for (Material& material : scene.materials) {
        if (auto* taught = std::get_if<TaughtMaterial>(&material.model)) taught->emission *= 2;
        if (auto* gltf = std::get_if<GltfMaterial>(&material.model)) gltf->emissiveStrength *= 2;
    }
    return scene;
}

class BuiltInPicture : public testing::TestWithParam<std::filesystem::path> {
protected:
    std::vector<Color> pictureOf(const Scene& changed, AccelKind accel = AccelKind::Auto) const {
        const TileResult tile = Tracing(changed, settings, kWidth, kHeight, accel).tile();
        EXPECT_EQ(tile.counts.invalidSamples, 0U);
        EXPECT_TRUE(std::ranges::all_of(tile.radiance, [](const Color& c) { return isFinite(c); }));
        return tile.radiance;
    }

    ImportReport report;
    const Scene scene = importGltf(GetParam(), report);
    const TraceSettings settings = toDepth(5);
    const std::vector<Color> picture = pictureOf(scene);
};

TEST_P(BuiltInPicture, IsTheSameByEveryIndex) {
    for (const AccelKind accel : {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8})
        EXPECT_EQ(different(picture, pictureOf(scene, accel)), 0);
}

TEST_P(BuiltInPicture, IsTheSameOnAnyNumberOfThreadsAndInParts) {
    const auto world = buildWorld(std::make_shared<const Scene>(scene), {});
    const auto rendered = [&](int threads, int firstPass, int samples, int smaller = 1) {
        RenderSession session(threads);
        RenderSettings render;
        render.width = kWidth / smaller;
        render.height = kHeight / smaller;
        render.trace = settings;
        render.firstPass = firstPass;
        render.stop = {.samples = samples};
        session.start(world, scene.cameras.front(), render);
        while (session.wait(std::chrono::milliseconds(1000)).active()) {
        }
        const ColorImage image = session.image();
        return std::vector<Color>(image.values().begin(), image.values().end());
    };
    EXPECT_EQ(different(rendered(1, 0, 8), rendered(3, 0, 8)), 0);
    const std::vector<Color> whole = rendered(2, 0, 256, 4);
    std::vector<Color> parts(whole.size(), Color(0));
    for (int part = 0; part < 4; ++part) parts = sum(parts, rendered(2, 64 * part, 64, 4), 0.25F);
    EXPECT_EQ(different(whole, parts, 1e-5F), 0);
}

TEST_P(BuiltInPicture, IsTheSameOfTheSceneMovedByANode) {
    EXPECT_EQ(different(picture, pictureOf(mapped(scene, at({200, -30, 50}))), 1e-5F), 0);
}

TEST_P(BuiltInPicture, IsTheSameWhateverTheOrderOfTheObjects) {
    Scene shuffled = scene;
    cases::Random random(1);
    for (std::size_t i = shuffled.objects.size(); i > 1; --i)
        std::swap(shuffled.objects[i - 1],
                  shuffled.objects[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
    EXPECT_EQ(different(picture, pictureOf(shuffled)), 0);
}

TEST_P(BuiltInPicture, OfTheMirroredSceneIsMirroredBitForBit) {
    const DMat4 flip = glm::scale(DMat4(1), DVec3(-1, 1, 1));
    std::vector<Color> mirrored = pictureOf(mapped(scene, flip));
    for (std::size_t y = 0; y < kHeight; ++y)
        std::reverse(mirrored.begin() + static_cast<std::ptrdiff_t>(y * kWidth),
                     mirrored.begin() + static_cast<std::ptrdiff_t>((y + 1) * kWidth));
    EXPECT_EQ(different(picture, mirrored), 0);
}

TEST_P(BuiltInPicture, OfTwiceTheLightIsTwiceAsBrightBitForBit) {
    EXPECT_EQ(different(scaled(picture, 2), pictureOf(twiceAsBright(scene))), 0);
}

TEST_P(BuiltInPicture, IsTheSumOfThoseByEachLamp) {
    Scene dark = scene;
    for (Light& light : dark.lights) light.intensity = 0; // its surface stays
    const std::vector<Color> base = pictureOf(dark);
    std::vector<Color> all = base;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        Scene alone = dark;
        alone.lights[i] = scene.lights[i];
        all = sum(sum(all, pictureOf(alone)), base, -1);
    }
    EXPECT_EQ(different(picture, all, 1e-5F), 0);
}

/// The same of the methods that throw dice, in fewer pixels.
class BuiltInPictureByChance : public testing::TestWithParam<std::tuple<std::filesystem::path, Method>> {
protected:
    std::vector<Color> pictureOf(const Scene& changed, AccelKind accel = AccelKind::Auto) const {
        TraceSettings settings = toDepth(4);
        settings.method = std::get<Method>(GetParam());
        std::vector<Color> all;
        const Tracing tracing(changed, settings, kWidth / 3, kHeight / 3, accel);
        for (int pass = 0; pass < 2; ++pass) {
            const TileResult tile = tracing.tile(pass);
            EXPECT_EQ(tile.counts.invalidSamples, 0U);
            all.insert(all.end(), tile.radiance.begin(), tile.radiance.end());
        }
        return all;
    }

    ImportReport report;
    const Scene scene = importGltf(std::get<0>(GetParam()), report);
    const std::vector<Color> picture = pictureOf(scene);
};

TEST_P(BuiltInPictureByChance, IsTheSameByEveryIndex) {
    for (const AccelKind accel : {AccelKind::Brute, AccelKind::Bvh2, AccelKind::Bvh8})
        EXPECT_EQ(different(picture, pictureOf(scene, accel)), 0);
}

TEST_P(BuiltInPictureByChance, OfTwiceTheLightIsTwiceAsBright) {
    EXPECT_EQ(different(scaled(picture, 2), pictureOf(twiceAsBright(scene)), 1e-5F), 0);
}

INSTANTIATE_TEST_SUITE_P(Assets, BuiltInPicture, testing::ValuesIn(sceneFiles()),
                         [](const auto& file) { return file.param.stem().string(); });

std::string nameOf(const testing::TestParamInfo<BuiltInPictureByChance::ParamType>& info) {
    const std::size_t method = static_cast<std::size_t>(std::get<Method>(info.param));
    return std::get<0>(info.param).stem().string() + "_" + std::string(kMethodNames[method]);
}

INSTANTIATE_TEST_SUITE_P(Assets, BuiltInPictureByChance,
                         testing::Combine(testing::ValuesIn(sceneFiles()),
                                          testing::Values(Method::Distributed, Method::Path)),
                         nameOf);

}
}
