// Samples of a pixel and what becomes of them: F48, F49, F53, F58, F62.

#include "core/base/thread_pool.h"
#include "core/render/textbook_film.h"
#include "core/study/stability_film.h"
#include "core/study/stability_groups.h"
#include "core/transport/valid_sample.h"

namespace eyeray {
namespace {

double meanOf(const ColorImage& image) {
    double sum = 0;
    for (const Color& value : image.values()) sum += value.r;
    return sum / static_cast<double>(image.values().size());
}

// A dim surface that a bright lamp reaches by few paths: 1/2, and 10⁴ in one sample of 10⁴.
MeasuredForms clamped(double level, const StabilityEffort& effort) {
    constexpr int kPasses = 64;
    constexpr float kDim = 0.5F, kBright = 1e4F;
    EvenFilm film(kTileSize);
    std::vector<float> samples;
    Real exact = 0;
    for (int pass = 0; pass < kPasses; ++pass) {
        for (Color& c : film.sample().radiance) {
            const auto trial = static_cast<std::uint32_t>(samples.size());
            samples.push_back(TrialNumbers(48, trial).uniform(0, kBright) < 1 ? kDim + kBright : kDim);
            exact += samples.back();
            c = Color(samples.back());
        }
        film.add();
    }
    const double truth = static_cast<double>(exact) / static_cast<double>(samples.size());
    const auto judged = [&](double mean, double nanoseconds) -> Measured {
        const double error = std::fabs(mean / truth - 1);
        return {error, error > 0.01 ? 1e6 : 0, nanoseconds};
    };
    const auto naive = [&](auto type) {
        using T = decltype(type);
        const auto most = static_cast<T>(level);
        double sum = 0;
        for (const float sample : samples) sum += std::min<T>(sample, most);
        T timed = 0;
        const double ns =
            nanosecondsOf(samples, effort, [&](float sample) { return timed += std::min<T>(sample, most); });
        return judged(sum / static_cast<double>(samples.size()), ns);
    };
    return {naive(float()), naive(double()), judged(meanOf(film.mean()), filmNanoseconds(effort))};
}

/// 1 with a probability, else 0: in sample number `pass` of a pixel.
float rareLight(double chance, std::size_t pixel, int pass) {
    constexpr std::uint32_t kMostPasses = 1 << 14;
    TrialNumbers numbers(49,
                         static_cast<std::uint32_t>(pixel) * kMostPasses + static_cast<std::uint32_t>(pass));
    return numbers.uniform(0, 1) < chance ? 1 : 0;
}

// Pixels that rare light reaches, traced until their standard error is small.
MeasuredForms stopped(double chance, const StabilityEffort& effort) {
    constexpr double kTolerance = 0.02;
    constexpr int kTiles = 4, kPixels = kTiles * kTilePixels;
    constexpr int kFirstLook = 16, kLooks = 8; // passes between looks
    const auto judged = [=](double mean, double nanoseconds) -> Measured {
        const double error = std::fabs(mean / chance - 1);
        return {error, error > 0.05 ? 1e6 : 0, nanoseconds};
    };
    const std::vector<float> few(1024, 0.5F);
    const auto naive = [&](auto type) {
        using T = decltype(type);
        double sum = 0;
        for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
            int pass = 0;
            sum +=
                textbook::meanUntilCalm<T>([&] { return rareLight(chance, pixel, pass++); }, T(kTolerance));
        }
        T all = 0, squares = 0;
        const double ns = nanosecondsOf(few, effort, [&](float x) { return all += x, squares += T(x) * x; });
        return judged(sum / kPixels, ns);
    };
    double sum = 0;
    for (std::size_t tile = 0; tile < kTiles; ++tile) {
        EvenFilm film(kTileSize);
        int passes = 0;
        do {
            for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel)
                film.sample().radiance[pixel] = Color(rareLight(chance, tile * kTilePixels + pixel, passes));
            film.add();
            ++passes;
        } while (passes < kFirstLook || passes % kLooks != 0 || film.estimatedError() > kTolerance);
        sum += meanOf(film.mean()) / kTiles;
    }
    return {naive(float()), naive(double()), judged(sum, filmNanoseconds(effort))};
}

/// Of the pixel whose lower edges lie v0 and v1 pixels under the horizon, the share of stripes of one metre
/// with an odd number, for an eye so high above them.
double stripes(double v0, double v1, double height, double focal) {
    const double far = height * focal / v0, near = height * focal / v1;
    Real share = 0;
    for (auto n = static_cast<long long>(std::floor(near)); static_cast<double>(n) < far; ++n) {
        if (n % 2 == 0) continue;
        const Real lo = std::max(near, static_cast<double>(n)),
                   hi = std::min(far, static_cast<double>(n) + 1);
        share += static_cast<Real>(height) * focal * (1 / lo - 1 / hi);
    }
    return static_cast<double>(share / (v1 - v0));
}

// A floor of stripes towards the horizon.
MeasuredForms aliased(double row, const StabilityEffort& effort) {
    constexpr double kEye = 1.5, kFocal = 618.038672; // metres; pixels, of 512 rows of 45°
    constexpr int kSamples = 256;
    const double truth = stripes(row, row + 1, kEye, kFocal);
    const auto inputs = numbered(std::max(64, effort.trials / kSamples));
    const auto odd = [=](auto v) {
        return (static_cast<long long>(std::floor(decltype(v)(kEye * kFocal) / v)) & 1) != 0;
    };
    const auto judge = [=](std::uint32_t, double share) -> Verdict {
        const double error = std::fabs(share - truth);
        return {error, error > 0.15};
    };
    return compared(
        inputs, effort,
        [=](std::uint32_t, auto type) -> double {
            using T = decltype(type);
            return odd(pinned(static_cast<T>(row) + T(0.5))) ? 1 : 0;
        },
        [=](std::uint32_t pixel) -> double {
            int sum = 0;
            for (std::uint32_t pass = 0; pass < kSamples; ++pass)
                sum += odd(row + pixelSample({.x = pixel, .pass = pass}).y) ? 1 : 0;
            return sum / static_cast<double>(kSamples);
        },
        judge);
}

// One sample of a thousand is not a number.
MeasuredForms spoiled(double samples, const StabilityEffort& effort) {
    constexpr double kBadShare = 1e-3;
    const int count = static_cast<int>(std::lround(samples));
    EvenFilm film(kTileSize);
    RayCounts counts;
    std::vector<float> floats(kTilePixels);
    std::vector<double> doubles(kTilePixels), truths(kTilePixels);
    for (int i = 0; i < count; ++i) {
        for (std::size_t pixel = 0; pixel < truths.size(); ++pixel) {
            TrialNumbers numbers(58, static_cast<std::uint32_t>(static_cast<int>(pixel) * count + i));
            const bool bad = numbers.uniform(0, 1) < kBadShare;
            const auto value = bad ? NAN : static_cast<float>(numbers.uniform(0, 1));
            floats[pixel] += value;
            doubles[pixel] += value;
            truths[pixel] += bad ? 0 : value;
            film.sample().radiance[pixel] = validSample(Color(value), counts);
        }
        film.add();
    }
    const ColorImage mean = film.mean();
    const auto judged = [&](const auto& at, double nanoseconds) {
        Measured all{0, 0, nanoseconds};
        for (std::size_t pixel = 0; pixel < truths.size(); ++pixel) {
            const double error = std::fabs(at(pixel) - truths[pixel] / samples);
            if (std::isfinite(error)) all.error = std::max(all.error, error);
            all.failuresPerMillion += std::isfinite(error) ? 0 : 1e6 / kTilePixels;
        }
        return all;
    };
    const std::vector<float> few(1024, 0.5F);
    const auto addition = [&](auto sum) {
        return nanosecondsOf(few, effort, [&](float x) { return sum += x; });
    };
    return {judged([&](std::size_t i) { return static_cast<double>(floats[i]) / samples; }, addition(0.0F)),
            judged([&](std::size_t i) { return doubles[i] / samples; }, addition(0.0)),
            judged([&](std::size_t i) { return static_cast<double>(mean.values()[i].r); },
                   filmNanoseconds(effort))};
}

/// A film of several tiles after 64 passes, each tile by whichever thread is free.
ColorImage filmOf(int threads) {
    constexpr int kSide = 4 * kTileSize, kPasses = 64;
    ThreadPool pool(threads);
    Film film(kSide, kSide);
    for (int pass = 0; pass < kPasses; ++pass)
        pool.forEach(film.tiles(), {}, [&](int tile) {
            TileResult result{.tile = film.tile(tile), .radiance = {}, .counts = {}, .complete = true};
            for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
                const auto at = static_cast<std::uint32_t>(tile) * kTilePixels + pixel;
                TrialNumbers numbers(62, at * kPasses + static_cast<std::uint32_t>(pass));
                result.radiance.emplace_back(static_cast<float>(numbers.uniform(0, 100)));
            }
            film.add(tile, result, pass);
        });
    return film.mean(kPasses);
}

// The same sum on so many threads, beside that on one.
MeasuredForms onThreads(double threads, const StabilityEffort& effort) {
    const int parts = static_cast<int>(std::lround(threads));
    const auto samples = inputsOf(std::max(1000, effort.trials), 62, [](TrialNumbers& numbers) {
        return static_cast<float>(numbers.uniform(0, 100));
    });
    const auto judged = [](double sum, double alone, double nanoseconds) -> Measured {
        return {std::fabs(sum / alone - 1), sum != alone ? 1e6 : 0, nanoseconds};
    };
    const auto naive = [&](auto type) {
        using T = decltype(type);
        T timed = 0;
        const double ns = nanosecondsOf(samples, effort, [&](float x) { return timed += x; });
        return judged(textbook::sumOfParts<T>(samples, parts), textbook::sumOfParts<T>(samples, 1), ns);
    };
    static const ColorImage alone = filmOf(1);
    const ColorImage together = filmOf(parts);
    Measured robust = judged(meanOf(together), meanOf(alone), filmNanoseconds(effort));
    if (together.values() != alone.values()) robust.failuresPerMillion = 1e6;
    return {naive(float()), naive(double()), robust};
}

}

std::vector<StabilityCase> pixelCases() {
    return {
        {.id = "F48",
         .title = "Fireflies clamped away",
         .why = "few bright samples carry most of the light: calm pixels of a darker scene",
         .fix = "nothing is clamped; sums in double",
         .parameter = "clamp",
         .error = "relative error of the mean",
         .failure = "off by more than 1 %",
         .sweep = decades(0, 5),
         .mark = {1e-5, 0},
         .measure = clamped},
        {.id = "F49",
         .title = "Pixels that stop by their own error",
         .why = "one that by chance met no light in 16 samples calls itself done: rare light gets lost",
         .fix = "the error of all pixels of a tile together (after Kirk, Arvo, SIGGRAPH 1991)",
         .parameter = "share of samples that meet light",
         .error = "relative error of the mean over all pixels",
         .failure = "off by more than 5 %",
         .sweep = {0.02, 0.03, 0.05, 0.1, 0.2, 0.5},
         .mark = {0.05, 0},
         .measure = stopped},
        {.id = "F53",
         .title = "One place for a whole pixel",
         .why = "many stripes in a pixel, and its middle lies on one of them: moiré",
         .fix = "samples all over the pixel: here 256 (Crow 1977; Burley 2020, JCGT 10(4))",
         .parameter = "rows of pixels below the horizon",
         .error = "error of the share of odd stripes in a pixel",
         .failure = "off by more than 0.15",
         .sweep = {1, 2, 5, 10, 20, 30, 60, 100, 200},
         .mark = {0.15, 0},
         .measure = aliased},
        {.id = "F58",
         .title = "Samples that are no numbers",
         .why = "NaN + x is NaN: one sample of many blackens its pixel for ever",
         .fix = "such samples are black, and counted for all to see",
         .parameter = "samples in a pixel, 0.1 % of them NaN",
         .error = "error of the pixels that are left",
         .failure = "pixels that are no numbers",
         .sweep = {1, 4, 16, 64, 256, 1024},
         .showsFailures = true,
         .mark = {1e-6, 0},
         .measure = spoiled},
        {.id = "F62",
         .title = "Sums in the order of threads",
         .why = "(a + b) + c is not a + (b + c): each number of threads has another picture",
         .fix = "a pixel's passes are added in their order, whoever traces them",
         .parameter = "threads",
         .error = "relative change of the sum",
         .failure = "another sum than on one thread",
         .sweep = {1, 2, 3, 4, 8, 16},
         .mark = {0, 0},
         .measure = onThreads},
    };
}

}
