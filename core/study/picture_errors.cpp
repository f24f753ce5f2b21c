#include "core/study/picture_errors.h"

#include <cmath>

#include "core/image/flip.h"
#include "core/image/metrics.h"
#include "core/study/color_map.h"
#include "core/study/palette.h"
#include "core/study/svg.h"

namespace eyeray {
namespace {

ColorImage fractions(const ByteImage& bytes) {
    ColorImage result(bytes.width(), bytes.height());
    for (std::size_t i = 0; i < bytes.values().size(); ++i) {
        const Rgba8& byte = bytes.values()[i];
        result.values()[i] = Color(byte.r, byte.g, byte.b) / 255.0F;
    }
    return result;
}

}

PictureErrors errorsOf(const ColorImage& reference, const ColorImage& test, const DisplaySettings& settings) {
    const ByteImage shownReference = display(reference, settings), shownTest = display(test, settings);
    const ColorImage a = fractions(shownReference), b = fractions(shownTest);
    return {{rmse(reference, test), relativeMse(reference, test), percentile95(reference, test), rmse(a, b),
             percentile95(a, b), meanFlip(flip(shownReference, shownTest))}};
}

ByteImage differencePicture(const ColorImage& reference, const ColorImage& test, double exposure,
                            const Axis& axis) {
    ByteImage result(reference.width(), reference.height());
    const auto scale = static_cast<float>(std::exp2(exposure));
    for (std::size_t i = 0; i < result.values().size(); ++i) {
        const float difference = maxComponent(glm::abs(reference.values()[i] - test.values()[i])) * scale;
        result.values()[i] = heatColor(difference > 0 ? axis.share(difference) : 0);
    }
    return result;
}

std::string svgOfHeat(const Axis& axis, const std::string& title) {
    constexpr float kWidth = 960, kHeight = 84, kMargin = 40, kTop = 30, kBar = 20, kLetter = 14;
    constexpr int kSteps = 128;
    const Ground& light = groundOf(false);
    const Ground& dark = groundOf(true);
    Svg svg(kWidth, kHeight, light.panel);
    svg.twinColors(std::array{std::array{light.panel, dark.panel}, std::array{light.text, dark.text}});
    svg.text({kMargin, 20}, title, {.size = kLetter, .color = light.text});
    constexpr float kLength = kWidth - 2 * kMargin, kStep = kLength / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const Rgba8 color = heatColor((i + 0.5) / kSteps);
        svg.box({kMargin + static_cast<float>(i) * kStep, kTop}, {kStep + 0.5F, kBar}, 0,
                static_cast<std::uint32_t>(color.r) << 16U | static_cast<std::uint32_t>(color.g) << 8U |
                    color.b);
    }
    for (const Tick& tick : ticksOf(axis, 8))
        svg.text(
            {kMargin + static_cast<float>(axis.share(tick.value)) * kLength, kTop + kBar + 1.3F * kLetter},
            tick.label, {.size = kLetter, .color = light.text, .anchor = Svg::Anchor::Middle});
    return svg.file();
}

}
