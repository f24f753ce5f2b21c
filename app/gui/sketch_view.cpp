#include "app/gui/sketch_view.h"

#include <algorithm>
#include <optional>

#include <glm/common.hpp>

namespace eyeray {
namespace {

ImU32 packed(const Ink& ink) { return ImGui::ColorConvertFloat4ToU32({ink.r, ink.g, ink.b, ink.a}); }

void drawPath(ImDrawList& list, const SketchPath& path, ImVec2 corner) {
    ImVector<ImVec2> points;
    points.reserve(static_cast<int>(path.points.size()));
    for (const Vec2& p : path.points) points.push_back({corner.x + p.x, corner.y + p.y});
    if (path.width > 0)
        list.AddPolyline(points.Data, points.Size, packed(path.ink), 0, path.width);
    else
        list.AddConvexPolyFilled(points.Data, points.Size, packed(path.ink));
}

/// Finds places for labels, one after the other.
class LabelPlaces {
public:
    explicit LabelPlaces(Vec2 size) : size_(size) {}

    /// Top left corner of a free place of this extent near to `wanted`, if there is one.
    std::optional<Vec2> take(const Vec2& wanted, const Vec2& extent) {
        const Vec2 inside = glm::clamp(wanted, Vec2(0), glm::max(size_ - extent, Vec2(0)));
        for (const float rows : {0.0F, 0.6F, -0.6F, 1.2F, -1.2F, 2.0F, -2.0F}) {
            const Vec2 place = inside + Vec2(0, rows * extent.y);
            if (!free(place, extent)) continue;
            taken_.push_back({place, place + extent});
            return place;
        }
        return std::nullopt;
    }

private:
    struct Rect {
        Vec2 lo, hi;
    };
    bool free(const Vec2& at, const Vec2& extent) const {
        if (at.y < 0 || at.y + extent.y > size_.y) return false;
        return std::none_of(taken_.begin(), taken_.end(), [&](const Rect& r) {
            return at.x < r.hi.x && r.lo.x < at.x + extent.x && at.y < r.hi.y && r.lo.y < at.y + extent.y;
        });
    }

    Vec2 size_;
    std::vector<Rect> taken_;
};

void drawLabel(ImDrawList& list, const SketchLabel& label, LabelPlaces& places, ImVec2 corner, Ink ground) {
    const float height = ImGui::GetFontSize() * label.size;
    const char* const begin = label.text.c_str();
    const ImVec2 text = ImGui::GetFont()->CalcTextSizeA(height, FLT_MAX, 0, begin);
    const Vec2 margin(0.27F * height, 0.09F * height), extent(text.x, text.y);
    const auto place = places.take(label.at - label.anchor * extent - margin, extent + 2.0F * margin);
    if (!place) return;
    const ImVec2 lo{std::round(corner.x + place->x), std::round(corner.y + place->y)};
    ground.a = 0.62F;
    list.AddRectFilled(lo, {lo.x + text.x + 2 * margin.x, lo.y + text.y + 2 * margin.y}, packed(ground),
                       margin.x);
    list.AddText(ImGui::GetFont(), height, {lo.x + margin.x, lo.y + margin.y}, packed(label.ink), begin);
}

}

void drawSketch(ImDrawList& list, const Sketch& sketch, ImVec2 corner, ImVec2 size, const Ink& ground) {
    for (const SketchPath& path : sketch.paths) drawPath(list, path, corner);
    LabelPlaces places(Vec2(size.x, size.y));
    for (const SketchLabel& label : sketch.labels) {
        const bool inside =
            label.at.x >= 0 && label.at.y >= 0 && label.at.x <= size.x && label.at.y <= size.y;
        if (inside) drawLabel(list, label, places, corner, ground);
    }
}

}
