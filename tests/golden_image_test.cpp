// labels: image
// Every built-in scene looks as it did: small pictures against those in tests/golden. After a change that is
// meant to be seen,
//   EYERAY_UPDATE_GOLDEN=1 build/release/golden_image_test --gtest_filter='Each/*'
// writes them anew; look at each before it is committed.

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/document/scene_files.h"
#include "core/image/atomic_file.h"
#include "core/image/decode.h"
#include "core/image/encode.h"
#include "core/render/render_session.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 64;
constexpr int kSamples = 4;
constexpr std::size_t kMostBytes = 1U << 20U;

// Another compiler or math library rounds otherwise in the last bit. That moves a displayed value by one or,
// on its edge, two steps; and where a ray just misses an edge or just reflects totally it goes another way,
// which changes whole pixels, but few: one in a thousand, rounded up.
constexpr int kAllowedStep = 2; // of 255
constexpr std::size_t kPixelsPerOtherPixel = 1000;

const fs::path kGolden = fs::path(EYERAY_SOURCE_DIR) / "tests" / "golden";
const fs::path kOutput = fs::path(EYERAY_BINARY_DIR) / "golden";

ByteImage rendered(const Document& document) {
    const double aspect = document.aspect > 0 ? document.aspect : 16.0 / 9;
    RenderSettings settings = document.render;
    settings.width = kWidth;
    settings.height = static_cast<int>(std::lround(kWidth / aspect));
    settings.stop = {.samples = kSamples};
    settings.coarse = false;
    RenderSession session;
    session.start(buildWorld(document.scene, buildSettings(document)), document.camera, settings);
    while (session.wait(std::chrono::seconds(1)).active()) {
    }
    return display(session.image(), settings.display);
}

ByteImage goldenOf(const std::string& scene) {
    const fs::path file = kGolden / (scene + ".png");
    return decodeImage(readFile(file, kMostBytes), file.string()).pixels;
}

void write(const fs::path& file, const ByteImage& image) {
    fs::create_directories(file.parent_path());
    writeFileAtomically(file, encodeDisplayed(image, ImageFormat::Png, {}));
}

int largestStep(const Rgba8& a, const Rgba8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Pixels that differ by more than rounding can; all of them if the sizes differ.
std::size_t otherPixels(const ByteImage& a, const ByteImage& b) {
    if (a.width() != b.width() || a.height() != b.height()) return a.values().size();
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i)
        count += largestStep(a.values()[i], b.values()[i]) > kAllowedStep ? 1U : 0U;
    return count;
}

std::size_t allowedOtherPixels(const ByteImage& image) {
    return (image.values().size() + kPixelsPerOtherPixel - 1) / kPixelsPerOtherPixel;
}

/// Grey where the pictures agree, brighter or darker where `actual` is: four times the difference.
ByteImage difference(const ByteImage& actual, const ByteImage& golden) {
    ByteImage shown(actual.width(), actual.height());
    const auto shade = [](int a, int b) {
        return static_cast<std::uint8_t>(std::clamp(128 + 4 * (a - b), 0, 255));
    };
    for (std::size_t i = 0; i < shown.values().size(); ++i) {
        const Rgba8 a = actual.values()[i], b = golden.values()[i];
        shown.values()[i] = {shade(a.r, b.r), shade(a.g, b.g), shade(a.b, b.b)};
    }
    return shown;
}

class GoldenImage : public testing::TestWithParam<std::string> {};

TEST_P(GoldenImage, IsWhatTheSceneLooksLike) {
    const std::string name = GetParam();
    const std::size_t by = name.find("_by_");
    Document document = openScene(name.substr(0, by)).document;
    if (by != std::string::npos)
        document = apply(document, Command::parse("set method=" + name.substr(by + 4)));
    const ByteImage actual = rendered(document);
    if (std::getenv("EYERAY_UPDATE_GOLDEN") != nullptr) { // NOLINT(concurrency-mt-unsafe): nothing sets it
        write(kGolden / (name + ".png"), actual);
        GTEST_SKIP() << "written anew";
    }
    const ByteImage golden = goldenOf(name);
    const std::size_t others = otherPixels(actual, golden);
    if (others <= allowedOtherPixels(golden)) return;
    write(kOutput / (name + "-actual.png"), actual);
    if (actual.width() == golden.width() && actual.height() == golden.height())
        write(kOutput / (name + "-difference.png"), difference(actual, golden));
    ADD_FAILURE() << fmt::format("{} of {} pixels differ: see {}/{}-*.png", others, golden.values().size(),
                                 kOutput.string(), name);
}

/// Each scene as its file says, and some by the methods that draw at random: as it is, or NAME_by_METHOD.
std::vector<std::string> pictureNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.push_back(scene.name);
    for (const char* const name :
         {"cornell_by_path", "metals_by_path", "cornell_by_distributed", "metals_by_distributed"})
        names.emplace_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Each, GoldenImage, testing::ValuesIn(pictureNames()),
                         [](const auto& scene) { return scene.param; });

TEST(GoldenImages, BelongToTheBuiltInScenes) {
    const std::vector<std::string> names = pictureNames();
    for (const auto& entry : fs::directory_iterator(kGolden))
        EXPECT_NE(std::find(names.begin(), names.end(), entry.path().stem().string()), names.end())
            << entry.path() << " is a picture of no built-in scene";
}

TEST(GoldenImages, ShowAChangeOfOneMaterial) {
    const Document document = openScene("homage").document;
    const Document changed =
        apply(document, Command::parse("material material=mirror reflectivity=0.8,0.8,0.8"));
    const ByteImage golden = goldenOf("homage");
    EXPECT_GT(otherPixels(rendered(changed), golden), allowedOtherPixels(golden));
}

TEST(GoldenImages, ShowShadowsSwitchedOff) {
    const Document document = openScene("homage").document;
    const ByteImage golden = goldenOf("homage");
    EXPECT_GT(otherPixels(rendered(apply(document, Command::parse("set shadows=off"))), golden),
              allowedOtherPixels(golden));
}

}
}
