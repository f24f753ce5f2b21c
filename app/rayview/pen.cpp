#include "app/rayview/pen.h"

namespace eyeray {

void drawLine(Sketch& sketch, const DepthView& view, const ScreenLine& line, const Pen& pen) {
    const float length = glm::length(line.to.at - line.from.at);
    if (!(length > 0)) return;
    for (const VisiblePart& part : visibleParts(view, line)) {
        const float alpha = part.hidden ? kHiddenAlpha : 1.0F;
        eachDash(pen.dashes, part.from * length, part.to * length, [&](float from, float to) {
            const float fade = pen.fades ? 1 - 0.5F * (from + to) / length : 1.0F;
            sketch.line(line.at(from / length).at, line.at(to / length).at, faded(pen.ink, alpha * fade),
                        pen.width, pen.tag);
        });
    }
}

void drawDisc(Sketch& sketch, const Vec2& at, float radius, const Ink& ink, int tag) {
    constexpr int kSides = 20;
    std::vector<Vec2> points;
    for (int i = 0; i < kSides; ++i) {
        const float angle = 2 * kPi * static_cast<float>(i) / kSides;
        points.push_back(at + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    sketch.fill(std::move(points), ink, tag);
}

}
