// Samples added up and shown: F54 to F57.

#include "core/geometry/placement.h"
#include "core/geometry/shapes.h"
#include "core/geometry/textbook_plane.h"
#include "core/image/srgb.h"
#include "core/render/textbook_film.h"
#include "core/scene/textbook_checker.h"
#include "core/scene/texture.h"
#include "core/study/stability_film.h"
#include "core/study/stability_groups.h"

namespace eyeray {
namespace {

MeasuredForms checkered(double above, const StabilityEffort& effort) {
    constexpr double kHeight = 1; // of the plane: between two layers of cells
    struct Input {
        Ray ray;
        bool dark; // in truth
    };
    const DVec3 eye(Vec3(0.37, kHeight + above, 0.21));
    const double far = 13 * above; // metres
    const auto nearAnEdge = [](double x) {
        return std::fabs(x - std::round(x)) < 1e-3 + 1e-6 * std::fabs(x);
    };
    const auto inputs = inputsOf(effort.trials, 54, [&](TrialNumbers& numbers) {
        while (true) {
            const DVec3 target(numbers.uniform(-far, far), kHeight, numbers.uniform(-far, far));
            const Ray ray = rayFrom(eye, glm::normalize(target - eye));
            const Real t = (static_cast<Real>(kHeight) - ray.origin.y) / ray.direction.y;
            const auto x = static_cast<double>(ray.origin.x + t * ray.direction.x),
                       z = static_cast<double>(ray.origin.z + t * ray.direction.z);
            if (nearAnEdge(x) || nearAnEdge(z)) continue;
            return Input{ray, (std::lround(std::floor(x) + std::floor(z)) & 1) != 1};
        }
    });
    DMat4 map(1);
    map[3].y = kHeight;
    const Placement placement(map);
    Scene scene;
    scene.textures = {{"", CheckerTexture{Color(1), Color(0)}}};
    return compared(
        inputs, effort,
        [=](const Input& in, auto type) {
            using T = decltype(type);
            const textbook::RayOf<T> ray(in.ray);
            const auto t = textbook::intersectPlane<T>({0, 1, 0}, T(kHeight), ray);
            const auto p = ray.at(t.value_or(0));
            return textbook::isDarkCell(p.x, p.y, p.z);
        },
        [&](const Input& in) {
            const Ray local = placement.toObject(in.ray);
            const auto hit = intersect(Plane{}, local);
            if (!hit) return false;
            const Vec2 uv = textureCoordinates(Plane{}, surfaceAt(Plane{}, local, *hit), 0);
            return !isBlack(textureValue(scene, scene.textures.front(), uv, TextureCoding::Linear));
        },
        [](const Input& in, bool dark) { return dark != in.dark; });
}

MeasuredForms encodedBytes(double linear, const StabilityEffort& effort) {
    const auto inputs = inputsOf(effort.trials, 55, [&](TrialNumbers& numbers) {
        return static_cast<float>(linear * numbers.uniform(0.5, 1));
    });
    return compared(
        inputs, effort,
        [](float value, auto type) -> double { return textbook::encoded<decltype(type)>(value); },
        [](float value) -> double { return encodeSrgb8(value); },
        [](float value, double byte) -> Verdict {
            const double x = value; // IEC 61966-2-1:1999
            const double code = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
            const double error = std::fabs(byte - 255 * code);
            return {error, error > 1};
        });
}

// A firefly, then small samples.
MeasuredForms afterFirefly(double samples, const StabilityEffort& effort) {
    constexpr float kFirefly = 1e6F, kSmall = 0.01F;
    const int count = static_cast<int>(std::lround(samples));
    const double truth = (static_cast<double>(kFirefly) + (samples - 1) * kSmall) / samples;
    const auto verdict = [=](double mean, double nanoseconds) -> Measured {
        const double error = std::fabs(mean / truth - 1);
        return {error, error > 1e-3 ? 1e6 : 0, nanoseconds};
    };
    const auto naive = [&](auto sum) {
        sum = kFirefly;
        const float small[] = {kSmall};
        for (int i = 1; i < count; ++i) sum += small[0];
        const std::vector<float> few(1024, kSmall);
        auto timed = sum;
        const double ns = nanosecondsOf(few, effort, [&](float x) { return timed += x; });
        return verdict(sum / samples, ns);
    };
    EvenFilm film(1);
    film.sample().radiance[0] = Color(kFirefly);
    film.add();
    film.sample().radiance[0] = Color(kSmall);
    for (int i = 1; i < count; ++i) film.add();
    return {naive(float()), naive(double()), verdict(film.mean().at(0, 0).r, filmNanoseconds(effort))};
}

// Samples that are black or white, three of four white.
MeasuredForms eightBits(double samples, const StabilityEffort& effort) {
    const int count = static_cast<int>(std::lround(samples));
    EvenFilm film(kTileSize);
    std::vector<std::uint8_t> bytes(kTilePixels);
    std::vector<double> whites(kTilePixels);
    for (int i = 0; i < count; ++i) {
        for (std::size_t pixel = 0; pixel < whites.size(); ++pixel) {
            const bool white =
                TrialNumbers(57, static_cast<std::uint32_t>(static_cast<int>(pixel) * count + i))
                    .uniform(0, 4) < 3;
            film.sample().radiance[pixel] = Color(white ? 1 : 0);
            whites[pixel] += white ? 1 : 0;
            bytes[pixel] = textbook::blended(bytes[pixel], white ? 255 : 0, i + 1);
        }
        film.add();
    }
    const ByteImage shown = display(film.mean(), {.toneMap = ToneMap::None});
    Measured naive, robust;
    const auto judge = [](Measured& all, double error) {
        all.error = std::max(all.error, error);
        all.failuresPerMillion += error > 2 ? 1e6 / kTilePixels : 0;
    };
    for (std::size_t pixel = 0; pixel < whites.size(); ++pixel) {
        const double truth = 255 * whites[pixel] / count;
        judge(naive, std::fabs(bytes[pixel] - truth));
        judge(robust, std::fabs(shown.values()[pixel].r - truth));
    }
    naive.nanoseconds =
        nanosecondsOf(bytes, effort, [&](std::uint8_t mean) { return textbook::blended(mean, 255, count); });
    robust.nanoseconds = filmNanoseconds(effort);
    return {naive, std::nullopt, robust};
}

}

std::vector<StabilityCase> sumCases() {
    return {
        {.id = "F54",
         .title = "A checkerboard in space, on its own plane",
         .why = "floor(y) of a point on y = h is h or h − 1, as it is rounded",
         .fix = "the plane's own two coordinates",
         .parameter = "height of the eye over it, m",
         .error = "share of points of the wrong colour",
         .failure = "points of the wrong colour",
         .sweep = decades(0, 2, 4),
         .mark = {0, 0},
         .measure = checkered},
        {.id = "F55",
         .title = "A power of 2.2 for sRGB, cut to bytes",
         .why = "sRGB begins with a straight line, and cutting loses half a code",
         .fix = "the curve of IEC 61966-2-1, rounded",
         .parameter = "linear value",
         .error = "error, codes",
         .failure = "off by more than a code",
         .sweep = decades(-4, 0, 2),
         .mark = {0.5001, 0},
         .measure = encodedBytes},
        {.id = "F56",
         .title = "Sums in float",
         .why = "after a firefly of 10⁶ the next float is 0.06 away: samples of 0.01 add nothing",
         .fix = "sums in double",
         .parameter = "samples",
         .error = "relative error of the mean",
         .failure = "off by more than 0.1 %",
         .sweep = decades(2, 7),
         .mark = {1e-6, 0},
         .measure = afterFirefly},
        {.id = "F57",
         .title = "A film of 8 bits",
         .why = "the mean stops where a step of (x − mean)/n rounds to 0",
         .fix = "a film of doubles; bytes are for the screen",
         .parameter = "samples",
         .error = "error, codes",
         .failure = "pixels off by more than 2 codes",
         .sweep = {1, 4, 16, 64, 256, 1024, 4096},
         .mark = {0.5001, 0},
         .measure = eightBits},
    };
}

}
