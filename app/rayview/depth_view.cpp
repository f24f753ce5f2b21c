#include "app/rayview/depth_view.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr float kLook = 2; // pixels between looks
constexpr int kMostLooks = 1500;

/// The line's stretch of shares inside the picture; empty (from > to) if it passes by.
struct Stretch {
    float from = 0, to = 1;
};
Stretch insidePicture(const ScreenLine& line, float width, float height) {
    Stretch inside;
    const Vec2 delta = line.to.at - line.from.at;
    const auto clip = [&](float start, float step, float size) {
        if (step == 0) {
            if (start < 0 || start > size) inside.to = -1;
            return;
        }
        const float a = (0 - start) / step, b = (size - start) / step;
        inside.from = std::max(inside.from, std::min(a, b));
        inside.to = std::min(inside.to, std::max(a, b));
    };
    clip(line.from.at.x, delta.x, width);
    clip(line.from.at.y, delta.y, height);
    return inside;
}

}

bool DepthView::hidden(const ScreenPoint& p) const {
    const int x = static_cast<int>(p.at.x), y = static_cast<int>(p.at.y);
    if (p.at.x < 0 || p.at.y < 0 || x >= depth.width() || y >= depth.height()) return false;
    return p.depth > projection.distance(depth.at(x, y)) + tolerance;
}

std::vector<VisiblePart> visibleParts(const DepthView& view, const ScreenLine& line) {
    std::vector<VisiblePart> parts;
    const Stretch inside = insidePicture(line, static_cast<float>(view.projection.width()),
                                         static_cast<float>(view.projection.height()));
    if (!(inside.from < inside.to)) return parts;
    const float length = (inside.to - inside.from) * glm::length(line.to.at - line.from.at);
    const int looks = std::clamp(static_cast<int>(length / kLook), 1, kMostLooks);
    for (int i = 0; i < looks; ++i) {
        const auto share = [&](float step) {
            return inside.from + (inside.to - inside.from) * step / static_cast<float>(looks);
        };
        const float from = share(static_cast<float>(i)), to = share(static_cast<float>(i + 1));
        const bool hidden = view.hidden(line.at(0.5F * (from + to)));
        if (!parts.empty() && parts.back().hidden == hidden)
            parts.back().to = to;
        else
            parts.push_back({from, to, hidden});
    }
    return parts;
}

}
