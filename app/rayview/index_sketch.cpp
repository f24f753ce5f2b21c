#include "app/rayview/index_sketch.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/rayview/pen.h"

namespace eyeray {
namespace {

using Role = SpaceBox::Role;

constexpr float kEdge = 1.5F, kThinEdge = 1.0F; // pixels at scale 1
constexpr float kDash = 0.3F;                   // letters' heights
constexpr float kMany = 60; // more boxes than these are drawn thinner, and fainter the more there are
constexpr float kFillAlpha = 0.45F, kMissedAlpha = 0.6F;

const Ink& inkOf(const RayStyle& style, Role role) { return style.boxes[static_cast<std::size_t>(role)]; }

/// For one of so many boxes.
Pen penOf(const RayStyle& style, Role role, float boxes) {
    const bool missed = role == Role::Missed, many = boxes > kMany;
    Pen pen{.ink = inkOf(style, role),
            .width = (missed || many ? kThinEdge : kEdge) * style.scale,
            .dashes = {},
            .tag = -1};
    if (missed) pen.dashes = {kDash * style.letter, kDash * style.letter};
    if (missed) pen.ink = faded(pen.ink, kMissedAlpha);
    if (many) pen.ink = faded(pen.ink, std::sqrt(kMany / boxes));
    return pen;
}

void drawEdges(Sketch& sketch, const DepthView& view, const SpaceBox& box, const Pen& pen) {
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t axis = 1; axis < 8; axis *= 2) {
            if ((corner & axis) != 0) continue;
            const Vec3 &from = box.corners[corner], &to = box.corners[corner | axis];
            if (const auto line = view.projection.line(from, to)) drawLine(sketch, view, *line, pen);
        }
}

void drawTriangle(Sketch& sketch, const DepthView& view, const std::array<Vec3, 3>& triangle,
                  const RayStyle& style) {
    std::vector<Vec2> points;
    for (const Vec3& corner : triangle) {
        const auto at = view.projection.point(corner);
        if (!at) return;
        points.push_back(at->at);
    }
    points.push_back(points.front());
    const Ink& ink = inkOf(style, Role::Tested);
    sketch.fill({points[0], points[1], points[2]}, faded(ink, kFillAlpha));
    sketch.paths.push_back({points, ink, kEdge * style.scale});
}

struct LegendRow {
    Role role;
    std::size_t count;
    const char *one, *many;
};

}

void drawIndex(Sketch& sketch, const DepthView& view, const IndexPicture& index, const RayStyle& style) {
    const auto boxes = static_cast<float>(index.boxes.size());
    // what is missed lies under what is met
    for (const Role role : {Role::Missed, Role::TopLevel, Role::Mesh, Role::Met, Role::Tested})
        for (const SpaceBox& box : index.boxes)
            if (box.role == role) drawEdges(sketch, view, box, penOf(style, role, boxes));
    for (const auto& triangle : index.triangles) drawTriangle(sketch, view, triangle, style);
}

void drawIndexLegend(Sketch& sketch, const IndexPicture& index, const RayStyle& style, const Vec2& corner) {
    const auto boxes = [&](Role role) {
        return static_cast<std::size_t>(std::ranges::count(index.boxes, role, &SpaceBox::role));
    };
    const float row = 1.35F * style.letter, line = 2.1F * style.letter;
    float y = corner.y - 0.5F * row;
    for (const LegendRow& entry :
         {LegendRow{Role::Tested, index.triangles.size(), "triangle tested", "triangles tested"},
          LegendRow{Role::Tested, boxes(Role::Tested), "shape tested", "shapes tested"},
          LegendRow{Role::Missed, boxes(Role::Missed), "box missed", "boxes missed"},
          LegendRow{Role::Met, boxes(Role::Met), "box hit", "boxes hit"},
          LegendRow{Role::Mesh, boxes(Role::Mesh), "box of a mesh", "boxes of meshes"},
          LegendRow{Role::TopLevel, boxes(Role::TopLevel), "box of objects", "boxes of objects"}}) {
        if (entry.count == 0) continue;
        const Pen pen = penOf(style, entry.role, 1);
        const Vec2 from(corner.x - line, y), to(corner.x, y);
        sketch.line(from, to, faded(style.ground, 0.6F), 7 * style.scale);
        eachDash(pen.dashes, 0, line, [&](float begin, float end) {
            sketch.line({from.x + begin, y}, {from.x + end, y}, inkOf(style, entry.role), 3 * style.scale);
        });
        sketch.labels.push_back(
            {from - Vec2(0.6F * style.letter, 0),
             fmt::format("{} {}{}", entry.count, entry.count == 1 ? entry.one : entry.many,
                         index.leftOut > 0 ? " drawn" : ""),
             inkOf(style, entry.role),
             {1, 0.5F},
             0.85F});
        y -= row;
    }
}

}
