#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/run.h"
#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "core/image/flip.h"
#include "core/image/metrics.h"
#include "core/image/read_picture.h"
#include "core/render/display.h"
#include "core/study/color_map.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

struct Shown {
    ColorImage linear;
    ByteImage displayed;
};

Shown read(const std::filesystem::path& path) {
    ReadPicture picture = readPicture(readFile(path, kMostBytes), path.string());
    ByteImage displayed = picture.displayed ? std::move(*picture.displayed) : display(picture.linear, {});
    return {std::move(picture.linear), std::move(displayed)};
}

/// The difference that the eye sees, in false colours.
void writeDifference(const std::filesystem::path& output, const Pixels<float>& differences) {
    ByteImage picture(differences.width(), differences.height());
    for (std::size_t i = 0; i < picture.values().size(); ++i)
        picture.values()[i] = heatColor(differences.values()[i]);
    writeFileAtomically(output, encodeDisplayed(picture, ImageFormat::Png, {}));
}

}

int run(const CompareOptions& options) {
    if (options.output) {
        checkOutput(*options.output);
        if (formatOf(*options.output) != ImageFormat::Png)
            throw InputError(options.output->string(), "a difference picture is a PNG",
                             "end its name in .png");
    }
    const Shown a = read(options.reference), b = read(options.test);
    const double root = rmse(a.linear, b.linear), relative = relativeMse(a.linear, b.linear);
    const double largest = maxDifference(a.linear, b.linear), p95 = percentile95(a.linear, b.linear);
    const Pixels<float> seen = flip(a.displayed, b.displayed);
    const double flipMean = meanFlip(seen);
    const int largestByte = maxByteDifference(a.displayed, b.displayed);
    const std::size_t pixels = countDifferingPixels(a.displayed, b.displayed);
    if (options.output) writeDifference(*options.output, seen);
    if (options.json) {
        const nlohmann::ordered_json json{{"width", a.linear.width()},
                                          {"height", a.linear.height()},
                                          {"rmse", root},
                                          {"relmse", relative},
                                          {"p95", p95},
                                          {"max", largest},
                                          {"flip", flipMean},
                                          {"max_displayed", largestByte},
                                          {"pixels_differ", pixels}};
        fmt::print("{}\n", json.dump());
        return 0;
    }
    fmt::print("rmse    {:.6g}   root of the mean square, of linear light\n"
               "relmse  {:.6g}   mean square as a share of the first picture's\n"
               "p95     {:.6g}   95 of 100 values differ less\n"
               "max     {:.6g}\n"
               "flip    {:.6g}   mean difference that is seen, 0 to 1\n"
               "shown   {} of {} pixels differ, by up to {} of 255\n",
               root, relative, p95, largest, flipMean, pixels, a.displayed.values().size(), largestByte);
    return 0;
}

}
