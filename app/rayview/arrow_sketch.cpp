#include <algorithm>

#include "app/rayview/pen.h"
#include "app/rayview/ray_sketch.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

constexpr float kThinnest = 1.3F, kThickest = 3.8F; // pixels at scale 1, for weights 0 and 1
constexpr float kHaloAlpha = 0.45F;

void drawHead(Sketch& sketch, const DepthView& view, const ScreenLine& line, float share, const Pen& pen) {
    const ScreenPoint tip = line.at(share);
    const Vec2 along = line.to.at - line.from.at;
    const float length = glm::length(along), size = 3.2F * pen.width + 4;
    if (length < 1.5F * size) return;
    const Vec2 back = -size * along / length, side = 0.42F * Vec2(-back.y, back.x);
    const float alpha = view.hidden(tip) ? kHiddenAlpha : 1.0F;
    sketch.fill({tip.at, tip.at + back + side, tip.at + 0.75F * back, tip.at + back - side},
                faded(pen.ink, alpha), pen.tag);
}

void drawCross(Sketch& sketch, const Vec2& at, float arm, const Pen& pen) {
    for (const float side : {-1.0F, 1.0F})
        sketch.line(at - Vec2(arm, side * arm), at + Vec2(arm, side * arm), pen.ink, pen.width, pen.tag);
}

class ArrowPainter {
public:
    ArrowPainter(Sketch& sketch, const DepthView& view, const RayStyle& style, float thickness)
        : sketch_(sketch), view_(view), style_(style), thickness_(thickness) {}

    void draw(const Arrow& arrow, int tag, bool selected) {
        const Pen pen = penOf(arrow, tag);
        if (selected) highlight(arrow, pen);
        if (arrow.end == RayEnd::Blocked) return blocked(arrow, pen);
        const auto line = view_.projection.line(arrow.from, arrow.to);
        if (!line) return;
        halo(*line, pen);
        drawLine(sketch_, view_, *line, pen);
        drawHead(sketch_, view_, *line, arrow.endless ? 0.35F : 1.0F, pen);
        if (arrow.end == RayEnd::Hit) vertex(arrow, pen);
    }

private:
    Pen penOf(const Arrow& arrow, int tag) const {
        const float share = std::sqrt(std::clamp(arrow.weight, 0.0F, 1.0F));
        const float width = kThinnest + (kThickest - kThinnest) * share;
        std::vector<float> dashes;
        for (const float letters : dashesOf(arrow.kind)) dashes.push_back(letters * style_.letter);
        if (arrow.endless && dashes.empty()) dashes = {0.4F * style_.letter, 0.25F * style_.letter};
        return {.ink = faded(style_.kinds[static_cast<std::size_t>(arrow.kind)], arrow.opacity),
                .width = width * style_.scale * thickness_,
                .dashes = std::move(dashes),
                .fades = arrow.endless,
                .tag = tag};
    }

    void halo(const ScreenLine& line, Pen pen) {
        pen.ink = faded(style_.ground, kHaloAlpha);
        pen.width += 2 * style_.scale;
        pen.dashes = {};
        const bool crowded = thickness_ < 1;
        if (!pen.fades && !crowded) drawLine(sketch_, view_, line, pen);
    }

    void highlight(const Arrow& arrow, Pen pen) {
        const auto line = view_.projection.line(arrow.from, arrow.to);
        if (!line) return;
        pen.ink = faded(style_.highlight, 0.8F);
        pen.width += 5 * style_.scale;
        pen.dashes = {};
        drawLine(sketch_, view_, *line, pen);
    }

    void blocked(const Arrow& arrow, Pen pen) {
        const auto before = view_.projection.line(arrow.from, arrow.blocker);
        const auto behind = view_.projection.line(arrow.blocker, arrow.to);
        if (behind) {
            Pen dark = pen;
            dark.ink = style_.unlit;
            drawLine(sketch_, view_, *behind, dark);
        }
        pen.ink = style_.blocked;
        if (before) {
            halo(*before, pen);
            drawLine(sketch_, view_, *before, pen);
        }
        const auto at = view_.projection.point(arrow.blocker);
        if (!at) return;
        Pen cross = pen;
        cross.ink = faded(pen.ink, view_.hidden(*at) ? 0.6F : 1.0F);
        cross.width = 2 * style_.scale * thickness_;
        drawCross(sketch_, at->at, 4.5F * style_.scale * thickness_, cross);
    }

    void vertex(const Arrow& arrow, const Pen& pen) {
        const auto at = view_.projection.point(arrow.to);
        if (!at || view_.hidden(*at)) return;
        drawDisc(sketch_, at->at, 0.55F * pen.width + 1.8F * style_.scale * thickness_, style_.ground,
                 pen.tag);
        drawDisc(sketch_, at->at, 0.55F * pen.width + 0.7F * style_.scale * thickness_, pen.ink, pen.tag);
    }

    Sketch& sketch_;
    const DepthView& view_;
    const RayStyle& style_;
    float thickness_;
};

float distanceToLine(const ScreenLine& line, const Vec2& p) {
    const Vec2 along = line.to.at - line.from.at;
    const float square = glm::dot(along, along);
    const float share =
        square > 0 ? std::clamp(glm::dot(p - line.from.at, along) / square, 0.0F, 1.0F) : 0.0F;
    return glm::length(p - (line.from.at + share * along));
}

}

void drawArrows(Sketch& sketch, const DepthView& view, const std::vector<Arrow>& arrows,
                const RayStyle& style, int selected, float thickness) {
    const auto depth = [&](const Arrow& arrow) {
        return glm::dot(DVec3(0.5F * (arrow.from + arrow.to)) - view.projection.eye(),
                        -view.projection.axes().backward);
    };
    std::vector<std::pair<double, int>> order; // the farthest first, the selected one last
    for (std::size_t i = 0; i < arrows.size(); ++i) {
        const int index = static_cast<int>(i);
        order.emplace_back(index == selected ? -HUGE_VAL : depth(arrows[i]), index);
    }
    std::sort(order.begin(), order.end(), std::greater<>());
    ArrowPainter painter(sketch, view, style, thickness);
    for (const auto& [distance, index] : order)
        painter.draw(arrows[static_cast<std::size_t>(index)], index, index == selected);
}

int arrowAt(const Projection& projection, const std::vector<Arrow>& arrows, const Vec2& point, float within) {
    int nearest = -1;
    for (std::size_t i = 0; i < arrows.size(); ++i) {
        if (arrows[i].sample != 0) continue;
        const auto line = projection.line(arrows[i].from, arrows[i].to);
        if (!line) continue;
        const float distance = distanceToLine(*line, point);
        if (distance >= within) continue;
        within = distance;
        nearest = static_cast<int>(i);
    }
    return nearest;
}

}
