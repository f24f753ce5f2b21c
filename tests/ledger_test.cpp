// labels: unit
#include <algorithm>
#include <bit>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "core/render/render_session.h"
#include "core/scene/gltf.h"
#include "core/study/ledger.h"
#include "tests/scenes.h"

namespace eyeray {
namespace {

using namespace scenes;

bool sameBits(const Color& a, const Color& b) {
    for (int c = 0; c < 3; ++c)
        if (std::bit_cast<std::uint32_t>(a[c]) != std::bit_cast<std::uint32_t>(b[c])) return false;
    return true;
}

/// The first node of this term, of this ray if one is named.
int nodeOf(const Ledger& ledger, Term term, int ray = -1) {
    const auto found = std::find_if(ledger.nodes.begin(), ledger.nodes.end(), [&](const LedgerNode& node) {
        return node.term == term && (ray < 0 || node.ray == ray);
    });
    if (found == ledger.nodes.end()) throw std::runtime_error("no such node");
    return static_cast<int>(found - ledger.nodes.begin());
}

/// Floor at y = 0 seen from above, with kd 0.5 and ka·Ia 0.05.
Scene floorFromAbove() {
    Scene scene = underSky(Color(0.25F));
    scene.ambient = Color(0.5F);
    add(scene, Plane{}, matte(Color(0.5F), Color(0.1F)));
    look(scene, {0, 4, 0}, {0, 0, 1e-3});
    return scene;
}

TEST(Ledger, OfAMatteFloorIsAmbientAndOneTermForEachLamp) {
    Scene scene = floorFromAbove();
    scene.lights = {taughtLampAt({0, 3, 0}, Color(0.8F)), taughtLampAt({3, 3, 0}, Color(0.5F))};
    const Ledger ledger = ledgerOf(Tracing(scene).retrace());
    const double oblique = 1 / std::sqrt(2.0);
    const double expected = 0.05 + 0.5 * 0.8 + 0.5 * 0.5 * oblique;
    EXPECT_NEAR(evaluate(ledger).g, expected, 1e-3);
    EXPECT_NEAR(ledger.at(nodeOf(ledger, Term::Ambient)).value.r, 0.05, 1e-7);
    const int arriving = nodeOf(ledger, Term::Arriving);
    EXPECT_EQ(ledger.operandsOf(arriving).size(), 4U) << "Le, ka Ia and two lamps";
}

TEST(Ledger, OfTheSkyIsItsBackground) {
    const Ledger ledger = ledgerOf(Tracing(underSky(Color(0.3F))).retrace());
    ASSERT_EQ(ledger.nodes.size(), 2U);
    EXPECT_EQ(ledger.nodes[1].term, Term::Background);
    EXPECT_EQ(evaluate(ledger), Color(0.3F));
}

TEST(Ledger, OfNothingIsBlack) { EXPECT_EQ(evaluate(ledgerOf(SampleRecord{})), Color(0)); }

TEST(Ledger, OfTintedGlassHasTheTransmittanceOfItsThickness) {
    constexpr float kSigma = 0.7F, kThickness = 2;
    Scene scene = underSky(Color(1));
    add(scene, Box{{4, 4, kThickness}}, glass(1, Color(1), Color(kSigma)), at({0, 0, -5}));
    const Ledger ledger = ledgerOf(Tracing(scene).retrace());
    const int inside = nodeOf(ledger, Term::Transmittance);
    EXPECT_NEAR(ledger.at(inside).value.r, std::exp(-kSigma * kThickness), 1e-5);
    EXPECT_NEAR(evaluate(ledger).r, std::exp(-kSigma * kThickness), 1e-5);
    const Strike clear = strikeOf(ledger, inside);
    EXPECT_EQ(evaluate(ledger, {&clear, 1}), Color(1)) << "T struck out lets all through";
}

TEST(Ledger, OfMirrorAndGlassNestsWhatTheySee) {
    Scene scene = underSky(Color(0.5F));
    TaughtMaterial both = glass(1, Color(0.25F));
    both.reflectivity = Color(0.5F);
    add(scene, Sphere{1}, both, at({0, 0, -3}));
    TraceSettings settings = toDepth(1);
    settings.fresnel = FresnelMode::Constant;
    const Ledger ledger = ledgerOf(Tracing(scene, settings).retrace());
    const int onward = nodeOf(ledger, Term::Onward);
    EXPECT_EQ(ledger.operandsOf(onward).size(), 2U);
    EXPECT_FLOAT_EQ(evaluate(ledger).r, 0.25F) << "kr · sky; the inside of the sphere is too deep";
}

TEST(Ledger, AnUnblockedShadowRayGivesThePixelOfTheSceneWithoutItsBlocker) {
    Scene open = floorFromAbove();
    open.lights = {taughtLampAt({2, 3, 0}), taughtLampAt({-2, 3, 1})};
    Scene blocked = open;
    add(blocked, Sphere{0.3F}, matte(Color(1)), at({1, 1.5, 0}));
    const Ledger ledger = ledgerOf(Tracing(blocked).retrace());
    const Color bright = Tracing(open).pixel();
    ASSERT_LT(evaluate(ledger).r, bright.r);
    const Strike unblocked = strikeOf(ledger, nodeOf(ledger, Term::Visibility));
    EXPECT_TRUE(sameBits(evaluate(ledger, {&unblocked, 1}), bright));
}

TEST(Ledger, AnUnblockedShadowRayStruckOutIsBlocked) {
    Scene scene = floorFromAbove();
    scene.lights = {taughtLampAt({2, 3, 0})};
    const Ledger ledger = ledgerOf(Tracing(scene).retrace());
    const int visibility = nodeOf(ledger, Term::Visibility), lamp = nodeOf(ledger, Term::Lamp);
    const Strike blocked = strikeOf(ledger, visibility);
    EXPECT_EQ(blocked, (Strike{visibility, Color(0)}));
    EXPECT_EQ(valueOf(ledger, lamp, {&blocked, 1}), Color(0));
    EXPECT_GT(valueOf(ledger, lamp, {}).r, 0);
    EXPECT_EQ(evaluate(ledger, {&blocked, 1}), ledger.at(nodeOf(ledger, Term::Ambient)).value);
}

TEST(Ledger, ALampStruckOutGivesThePixelWithoutTheLamp) {
    Scene both = floorFromAbove();
    both.lights = {taughtLampAt({2, 3, 0}), taughtLampAt({-2, 3, 1})};
    Scene one = both;
    one.lights.erase(one.lights.begin());
    const Ledger ledger = ledgerOf(Tracing(both).retrace());
    const Strike strike = strikeOf(ledger, nodeOf(ledger, Term::Lamp));
    EXPECT_TRUE(sameBits(evaluate(ledger, {&strike, 1}), Tracing(one).pixel()));
}

TEST(Ledger, SeveralStrikesActTogetherAndOneWithinAnotherIsIdle) {
    Scene scene = floorFromAbove();
    scene.lights = {taughtLampAt({2, 3, 0})};
    const Ledger ledger = ledgerOf(Tracing(scene).retrace());
    std::vector<Strike> strikes = {strikeOf(ledger, nodeOf(ledger, Term::Ambient)),
                                   strikeOf(ledger, nodeOf(ledger, Term::Lamp)),
                                   strikeOf(ledger, nodeOf(ledger, Term::Diffuse))};
    EXPECT_EQ(evaluate(ledger, strikes), Color(0));
}

TEST(Ledger, OfASampleThatIsNotFiniteIsBlackAsInTheFilm) {
    const Tracing tracing(underSky(Color(std::numeric_limits<float>::infinity())));
    EXPECT_EQ(evaluate(ledgerOf(tracing.retrace())), Color(0));
    EXPECT_EQ(tracing.radiance().front(), Color(0));
}

struct Variant {
    const char* name;
    TraceSettings settings;
};

std::vector<Variant> variants() {
    TraceSettings exact, constant, lit, deep = toDepth(16), flat = toDepth(0), cast, opaque = toDepth(2);
    constant.fresnel = FresnelMode::Constant;
    lit.shadows = false;
    flat.cutoff = 0.05F;
    cast.method = Method::Cast;
    opaque.glassShadows = GlassShadows::OpaqueOnly;
    opaque.refractions = false;
    return {{"exact", exact},          {"constant weights", constant},
            {"no shadows", lit},       {"depth 16", deep},
            {"depth 0", flat},         {"cast", cast},
            {"no refractions", opaque}};
}

/// 21 scenes · 7 variants · 70 pixels: more than 10,000.
TEST(Ledger, HasTheFilmsBitsInRandomPixelsOfEveryScene) {
    constexpr int kWidth = 96, kHeight = 54, kPixels = 70;
    int checked = 0;
    for (const auto& file : std::filesystem::directory_iterator(EYERAY_SOURCE_DIR "/assets/scenes")) {
        ImportReport report;
        const auto world = buildWorld(std::make_shared<const Scene>(importGltf(file.path(), report)), {});
        std::mt19937 random(static_cast<unsigned>(checked));
        for (const Variant& variant : variants()) {
            const Tracing tracing(world, variant.settings, kWidth, kHeight);
            const FloatEnvironment environment;
            for (int i = 0; i < kPixels; ++i, ++checked) {
                const int x = static_cast<int>(random() % kWidth), y = static_cast<int>(random() % kHeight),
                          pass = static_cast<int>(random() % 9);
                const Color film = tracing.integrator()
                                       .renderTile(tracing.context(), {x, y, x + 1, y + 1}, pass)
                                       .radiance.front();
                const Retrace trace = tracing.retrace(x, y, pass);
                ASSERT_TRUE(sameBits(trace.radiance, film)) << "recorder on or off: " << file.path();
                const Ledger ledger = ledgerOf(trace);
                ASSERT_TRUE(sameBits(evaluate(ledger), film))
                    << file.path() << ", " << variant.name << ", pixel " << x << ',' << y << ", pass "
                    << pass;
                ASSERT_EQ(ledger.at(0).end, static_cast<int>(ledger.nodes.size()));
            }
        }
    }
    EXPECT_GE(checked, 10'000);
}

TEST(Ledger, MeanOfRetracedSamplesHasTheFilmsBits) {
    constexpr int kSamples = 7, kWidth = 40, kHeight = 30;
    ImportReport report;
    const Scene scene = importGltf(EYERAY_SOURCE_DIR "/assets/scenes/homage.gltf", report);
    RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.stop.samples = kSamples;
    RenderSession session(2);
    session.start(buildWorld(std::make_shared<const Scene>(scene), {}), scene.cameras.front(), settings);
    while (session.wait(std::chrono::milliseconds(50)).active()) {
    }
    const ColorImage film = session.image();
    ASSERT_FALSE(film.empty());
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            PixelMean mean;
            for (int pass = 0; pass < kSamples; ++pass)
                mean.add(evaluate(ledgerOf(*session.retrace(x, y, pass))));
            ASSERT_TRUE(sameBits(mean.value(), film.at(x, y)));
        }
}

}
}
