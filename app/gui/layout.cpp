#include "app/gui/layout.h"

#include <algorithm>
#include <cmath>

namespace eyeray {
namespace {

constexpr float kLeastWidth = 13, kLeastHeight = 11; // of the rays in space, in letters' heights
constexpr float kLeastWords = 11;                    // height of the words
constexpr float kWordsShare = 0.4F;                  // of the height

Area part(const Area& area, float x0, float y0, float x1, float y1) {
    const ImVec2 lo{std::round(area.size.x * x0), std::round(area.size.y * y0)};
    const ImVec2 hi{std::round(area.size.x * x1), std::round(area.size.y * y1)};
    return {{area.at.x + lo.x, area.at.y + lo.y}, {hi.x - lo.x, hi.y - lo.y}};
}

}

ExplainLayout explainLayout(const Area& middle, float letter) {
    const float width = middle.size.x / letter, height = middle.size.y / letter;
    const bool wide = width >= 2 * kLeastWidth;
    const float views = (wide ? 1 : 2) * kLeastHeight;
    if (width < kLeastWidth || height < views) return {middle, std::nullopt, std::nullopt};
    const bool words = height >= views + kLeastWords;
    const float split = words ? std::min(1 - kWordsShare, 1 - kLeastWords / height) : 1;
    ExplainLayout layout;
    layout.picture = wide ? part(middle, 0, 0, 0.5F, split) : part(middle, 0, 0, 1, split / 2);
    layout.rays = wide ? part(middle, 0.5F, 0, 1, split) : part(middle, 0, split / 2, 1, split);
    if (words) layout.words = part(middle, 0, split, 1, 1);
    return layout;
}

}
