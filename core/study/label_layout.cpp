#include "core/study/label_layout.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

namespace eyeray {
namespace {

constexpr int kRings = 7; // tried outward from the point
// Where a label stands about its point: above to the right first, where falling lines leave room.
constexpr std::array<Vec2, 12> kSides = {Vec2{1, -1},    Vec2{1, 0},     Vec2{0, -1},   Vec2{-1, 1},
                                         Vec2{-1, 0},    Vec2{0, 1},     Vec2{1, 1},    Vec2{-1, -1},
                                         Vec2{0.5F, -1}, Vec2{-0.5F, 1}, Vec2{0.5F, 1}, Vec2{-0.5F, -1}};

struct Box {
    Vec2 low, high;
    bool overlaps(const Box& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

}

std::vector<std::optional<Vec2>> layOutLabels(std::span<const LabelledPoint> points, const Vec2& areaCorner,
                                              const Vec2& areaSize, float mark) {
    std::vector<Box> taken;
    for (const LabelledPoint& point : points) taken.push_back({point.at - mark, point.at + mark});
    const auto isFree = [&](const Box& box) {
        return box.low.x >= areaCorner.x && box.low.y >= areaCorner.y &&
               box.high.x <= areaCorner.x + areaSize.x && box.high.y <= areaCorner.y + areaSize.y &&
               std::ranges::none_of(taken, [&](const Box& other) { return box.overlaps(other); });
    };
    const auto place = [&](const LabelledPoint& point) -> std::optional<Vec2> {
        if (point.extent.x <= 0) return std::nullopt;
        for (int ring = 0; ring < kRings; ++ring)
            for (const Vec2& side : kSides) {
                const float away = mark + static_cast<float>(ring) * 0.6F * point.extent.y;
                const Vec2 corner =
                    point.at + side * (Vec2(away) + 0.5F * point.extent) - 0.5F * point.extent;
                const Box box{corner, corner + point.extent};
                if (!isFree(box)) continue;
                taken.push_back(box);
                return corner;
            }
        return std::nullopt;
    };
    std::vector<std::optional<Vec2>> corners;
    for (const LabelledPoint& point : points) corners.push_back(place(point));
    return corners;
}

}
