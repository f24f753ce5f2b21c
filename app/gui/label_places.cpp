#include "app/gui/label_places.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <optional>

#include <glm/common.hpp>
#include <imgui.h>

namespace eyeray {
namespace {

constexpr std::array kMoves = {0.0F, 0.6F, -0.6F, 1.2F, -1.2F, 2.0F, -2.0F}; // tried, in heights of a plate

/// Top left corner of a free place of this extent near to `wanted`, if there is one.
std::optional<Vec2> freePlace(const std::vector<PlacedLabel>& taken, const Vec2& size, const Vec2& wanted,
                              const Vec2& extent) {
    const Vec2 inside = glm::clamp(wanted, Vec2(0), glm::max(size - extent, Vec2(0)));
    for (const float move : kMoves) {
        const Vec2 lo = inside + Vec2(0, move * extent.y), hi = lo + extent;
        const bool free =
            lo.y >= 0 && hi.y <= size.y &&
            std::none_of(taken.begin(), taken.end(), [&](const PlacedLabel& other) {
                const Vec2 end = other.corner + other.extent;
                return lo.x < end.x && other.corner.x < hi.x && lo.y < end.y && other.corner.y < hi.y;
            });
        if (free) return glm::round(lo);
    }
    return std::nullopt;
}

}

std::vector<PlacedLabel> placeLabels(const Sketch& sketch, const Vec2& size, float letter) {
    std::vector<PlacedLabel> placed;
    for (const SketchLabel& label : sketch.labels) {
        if (glm::clamp(label.at, Vec2(0), size) != label.at) continue;
        const float height = letter * label.size;
        const ImVec2 text = ImGui::GetFont()->CalcTextSizeA(height, FLT_MAX, 0, label.text.c_str());
        const Vec2 margin(0.27F * height, 0.09F * height), extent = Vec2(text.x, text.y) + 2.0F * margin;
        const auto corner =
            freePlace(placed, size, label.at - label.anchor * (extent - 2.0F * margin) - margin, extent);
        if (corner) placed.push_back({&label, *corner, extent, *corner + margin, height});
    }
    return placed;
}

}
