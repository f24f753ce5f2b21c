#include "core/study/lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/study/lab_scenes.h"

namespace eyeray {
namespace {

/// The naive side whatever the slider says.
template <const auto& text>
std::string always(double /*value*/) {
    return std::string(text);
}

constexpr std::string_view kSphereSlide = "fault=sphere-slide";
constexpr std::string_view kSmallEpsilon = "fault=global-epsilon epsilon=0.0001";
constexpr std::string_view kMollerTrumbore = "fault=moller-trumbore";
constexpr std::string_view kFloatWorld = "fault=float-world";
constexpr std::string_view kNormalsByMatrix = "fault=normals-by-m";
constexpr std::string_view kGlass = "fault=schlick-inner-cosine,nan-refraction";
constexpr std::string_view kHardTerminator = "fault=hard-terminator";
constexpr std::string_view kRoulette = "fault=roulette-unweighted";
constexpr std::string_view kBadSeeding = "fault=bad-seeding";
constexpr std::string_view kSolidChecker = "fault=solid-checker";
constexpr std::string_view kCentreSampling = "fault=centre-sampling";

std::string epsilonOf(double value) { return fmt::format("fault=global-epsilon epsilon={:.6g}", value); }
std::string clampOf(double value) { return fmt::format("fault=early-clamp clamp={:.6g}", value); }
std::string cutoffOf(double value) { return fmt::format("cutoff={:.6g}", value); }
std::string depthOf(double value) { return fmt::format("max-depth={}", static_cast<int>(value)); }

constexpr double kStep = 0.05; // of a slider's way

constexpr std::array kDemos = {
    LabDemo{
        "lab-sphere",
        "A sphere far away",
        "b² − 4ac subtracts two numbers that agree in all their digits: misses become hits.",
        "By the ray's distance from the centre: Haines, Günther, Akenine-Möller, Ray Tracing Gems 2019, 7",
        {"distance, m", 10, 1e5, 3000, true, false},
        lab::distantSphere,
        always<kSphereSlide>},
    LabDemo{"lab-epsilon",
            "One epsilon for all",
            "Too small: surfaces shadow themselves. Too large: light leaks under what stands close.",
            "Offset by the hit point's own error bound: Pharr, Jakob, Humphreys, PBR 4th ed. 2023, 6.8.6",
            {"epsilon", 0, 1, 0, true, false},
            lab::plateOnFloor,
            epsilonOf},
    LabDemo{"lab-scale",
            "The same epsilon at another scale",
            "0.0001 m is nothing in a large scene and a wall in a small one.",
            "Offset by the hit point's own error bound: Pharr, Jakob, Humphreys, PBR 4th ed. 2023, 6.8.6",
            {"world scale", 1e-3, 1e5, 1e4, true, false},
            lab::scaledBalls,
            always<kSmallEpsilon>},
    LabDemo{"lab-leaks",
            "Sparks through a closed mesh",
            "Each triangle rounds its edges for itself: rays aimed at a shared one can miss both.",
            "The same edge test, by sign, on both sides: Woop, Benthin, Wald, JCGT 2(1) 2013",
            {"rows of triangles", 4, 256, 32, true, true},
            lab::closedBall,
            always<kMollerTrumbore>},
    LabDemo{"lab-holes",
            "Triangles that vanish",
            "A determinant below 0.000001 counts as parallel: so does every small or slanting triangle.",
            "Compare with 0 alone, one shear for all triangles: Woop, Benthin, Wald, JCGT 2(1) 2013",
            {"size, m", 1e-3, 10, 0.02, true, false},
            lab::smallKnot,
            always<kMollerTrumbore>},
    LabDemo{"lab-coplanar",
            "Two surfaces in one place",
            "Which is nearer is decided by rounding, anew at every pixel: it crawls with the tilt.",
            "No tracer can know: ties by number, exact t, and in the model a gap",
            {"tilt, degrees", 0, 60, 33, false, false},
            lab::coplanarQuads,
            always<kMollerTrumbore>},
    LabDemo{
        "lab-far",
        "Far from the origin",
        "At 10 000 km two neighbouring floats are a metre apart.",
        "Floats relative to the scene, transforms in double: Pharr, Jakob, Humphreys, PBR 4th ed. 2023, 6.1",
        {"moved by, m", 1, 1e7, 1e6, true, false},
        lab::farAway,
        always<kFloatWorld>},
    LabDemo{"lab-squash",
            "Normals of a squashed ball",
            "M stretches normals along with the surface: they no longer stand on it.",
            "The inverse transpose of M: Turkowski, Graphics Gems 1990",
            {"thickness", 0.05, 1, 0.2, true, false},
            lab::pancake,
            always<kNormalsByMatrix>},
    LabDemo{"lab-glass",
            "Out of glass",
            "Beyond 41.81° Snell's root is negative, and short of it Schlick takes the wrong angle.",
            "Fresnel's equations, all light reflected beyond: Born, Wolf, Principles of Optics 1999, 1.5",
            {"angle, degrees", 0, 80, 42, false, false},
            lab::insideGlass,
            always<kGlass>},
    LabDemo{"lab-terminator",
            "The terminator",
            "Smooth normals say lit where the flat facet already hides the lamp from itself.",
            "Start shadow rays on the smooth surface: Hanika, Ray Tracing Gems II 2021, 4",
            {"segments around", 8, 128, 16, true, true},
            lab::smoothBall,
            always<kHardTerminator>},
    LabDemo{"lab-tunnel",
            "Where recursion ends",
            "A fixed depth D loses ρ^(D + 1) of the light between mirrors: 31 % at 0.9 and 10.",
            "Depth by contribution: Hall, Greenberg 1983; without bias by roulette: Arvo, Kirk 1990",
            {"depth", 0, 24, 4, false, true},
            lab::mirrorTunnel,
            depthOf},
    LabDemo{"lab-cutoff",
            "A cutoff for faint rays",
            "Below the cutoff lies the whole tail of a series: ρ^k / (1 − ρ) of the light, not ρ^k.",
            "No cutoff, or roulette, which keeps the mean: Arvo, Kirk, SIGGRAPH 1990",
            {"cutoff", 1e-3, 1, 0.5, true, false},
            lab::faintRays,
            cutoffOf},
    LabDemo{"lab-roulette",
            "Roulette without its weights",
            "Paths that go on must stand for those that ended: without 1/p their light is lost.",
            "Divide by the probability of going on: Arvo, Kirk, SIGGRAPH 1990",
            {"walls reflect", 0.1, 0.9, 0.7, false, false},
            lab::whiteRoom,
            always<kRoulette>},
    LabDemo{"lab-fireflies",
            "Clamped fireflies",
            "Rare bright samples carry real light: clamping them buys a calm picture with a dark one.",
            "Better sampling, not a clamp: Veach, Guibas 1995; the mean is what must not change",
            {"clamp", 0.1, 1000, 1, true, false},
            lab::caustic,
            clampOf},
    LabDemo{"lab-seeds",
            "Random numbers by the pixel's number",
            "Neighbouring seeds give neighbouring numbers, and a generator seeded anew repeats itself.",
            "Hashed addresses and scrambled points: Burley, JCGT 10(4) 2020",
            {"samples", 1, 256, 16, true, true},
            lab::softShadow,
            always<kBadSeeding>},
    LabDemo{"lab-aliasing",
            "Aliasing",
            "One place speaks for a whole pixel: what is smaller becomes moiré, however many samples.",
            "Samples all over the pixel: Crow, CACM 20(11) 1977; Cook, ACM TOG 5(1) 1986",
            {"samples", 1, 256, 16, true, true},
            lab::checkerPlain,
            always<kCentreSampling>},
    LabDemo{"lab-checker",
            "A checker in three dimensions",
            "y is 0 give or take a rounding, and floor(y) flips the square; far away both sides alias.",
            "A checker in (u, v) of the surface; more samples for what is smaller than a pixel",
            {"samples", 1, 256, 1, true, true},
            lab::checkerPlain,
            always<kSolidChecker>},
};

}

std::span<const LabDemo> labDemos() { return kDemos; }

const LabDemo* labDemoNamed(std::string_view name) {
    const auto* const found =
        std::find_if(kDemos.begin(), kDemos.end(), [&](const LabDemo& demo) { return demo.name == name; });
    return found != kDemos.end() ? found : nullptr;
}

double labValue(const LabDemo& demo, double value) {
    const double inside = std::clamp(value, demo.slider.lowest, demo.slider.highest);
    return demo.slider.whole ? std::round(inside) : inside;
}

double labStep(const LabDemo& demo, double value, int steps) {
    const LabSlider& slider = demo.slider;
    // A logarithmic slider that reaches 0 has decades down to a float's last digit above it.
    const double lowest = slider.lowest > 0 ? slider.lowest : slider.highest * 1e-7;
    const auto place = [&](double at) {
        if (!slider.logarithmic) return (at - slider.lowest) / (slider.highest - slider.lowest);
        return at > lowest ? std::log(at / lowest) / std::log(slider.highest / lowest) : 0;
    };
    const double next = std::clamp(place(value) + steps * kStep, 0.0, 1.0);
    double moved = slider.lowest + next * (slider.highest - slider.lowest);
    if (slider.logarithmic)
        moved = next > 0 ? lowest * std::pow(slider.highest / lowest, next) : slider.lowest;
    const bool stays = slider.whole && std::round(moved) == value;
    return labValue(demo, stays ? value + steps : moved);
}

Scene labScene(const LabDemo& demo, double value) {
    Scene scene = demo.scene(labValue(demo, value));
    scene.name = demo.name;
    scene.whatToLookAt = demo.why;
    return scene;
}

}
