#include "app/rayview/ray_sketch.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/study/palette.h"

namespace eyeray {
namespace {

constexpr float kThinnest = 1.3F, kThickest = 3.8F; // pixels at scale 1, for weights 0 and 1
constexpr float kHiddenAlpha = 0.3F;
constexpr float kHaloAlpha = 0.45F;

Ink faded(Ink ink, float by) {
    ink.a *= by;
    return ink;
}

struct Pen {
    Ink ink;
    float width;
    std::vector<float> dashes; // pixels: dash, gap, …; none for a full line
    bool fades = false;        // towards its end
    int tag;
};

/// Calls piece(from, to) for each dash of [from, to], pixels along the line.
template <class Piece>
void eachDash(const std::vector<float>& dashes, float from, float to, const Piece& piece) {
    const float period = std::accumulate(dashes.begin(), dashes.end(), 0.0F);
    if (!(period > 0)) return piece(from, to);
    for (float start = std::floor(from / period) * period; start < to; start += period) {
        float at = start;
        for (std::size_t i = 0; i + 1 < dashes.size(); i += 2) {
            const float lo = std::max(from, at), hi = std::min(to, at + dashes[i]);
            if (hi > lo) piece(lo, hi);
            at += dashes[i] + dashes[i + 1];
        }
    }
}

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

void drawDisc(Sketch& sketch, const Vec2& at, float radius, const Ink& ink, int tag = -1) {
    constexpr int kSides = 20;
    std::vector<Vec2> points;
    for (int i = 0; i < kSides; ++i) {
        const float angle = 2 * kPi * static_cast<float>(i) / kSides;
        points.push_back(at + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    sketch.fill(std::move(points), ink, tag);
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
        return {.ink = style_.kinds[static_cast<std::size_t>(arrow.kind)],
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

void drawEye(Sketch& sketch, const DepthView& view, const ImagePlane& plane, const RayStyle& style,
             bool labels) {
    const Projection& projection = view.projection;
    const Pen thin{.ink = faded(style.text, 0.75F), .width = 1.2F * style.scale, .dashes = {}, .tag = -1};
    for (std::size_t i = 0; i < 4; ++i) {
        Pen edge = thin;
        edge.ink = faded(style.text, 0.35F);
        if (const auto line = projection.line(plane.eye, plane.corners[i]))
            drawLine(sketch, view, *line, edge);
        if (const auto line = projection.line(plane.corners[i], plane.corners[(i + 1) % 4]))
            drawLine(sketch, view, *line, thin);
    }
    const auto eye = projection.point(plane.eye);
    if (eye) {
        const float radius = 6 * style.scale;
        drawDisc(sketch, eye->at, radius + 1.5F * style.scale, style.ground);
        drawDisc(sketch, eye->at, radius, style.text);
        drawDisc(sketch, eye->at, 0.45F * radius, style.ground);
        if (labels) sketch.labels.push_back({eye->at - Vec2(0, 1.6F * radius), "eye", style.text, {0.5F, 1}});
    }
    if (!labels) return;
    const auto middle = projection.point(0.5 * (plane.corners[0] + plane.corners[2]));
    const auto a = projection.point(plane.corners[0]), b = projection.point(plane.corners[2]);
    if (!middle || !a || !b || glm::length(a->at - b->at) < 5 * style.letter) return;
    for (int i = 0; i < 4; ++i) {
        const auto corner = projection.point(plane.corners[static_cast<std::size_t>(i)]);
        if (!corner) continue;
        const Vec2 away = corner->at - middle->at;
        const Vec2 anchor(away.x > 0 ? 0.0F : 1.0F, away.y > 0 ? 0.0F : 1.0F);
        const Vec2 gap = 4 * style.scale * Vec2(away.x > 0 ? 1 : -1, away.y > 0 ? 1 : -1);
        sketch.labels.push_back({corner->at + gap, plane.cornerText(i), style.text, anchor, 0.82F});
    }
    if (plane.scale == 1) return;
    if (const auto below = projection.point(0.5 * (plane.corners[2] + plane.corners[3])))
        sketch.labels.push_back({below->at + Vec2(0, 1.5F * style.letter),
                                 fmt::format("drawn {:.2g} times as far", plane.scale),
                                 style.text,
                                 {0.5F, 0},
                                 0.75F});
}

void drawPixel(Sketch& sketch, const DepthView& view, const ImagePlane& plane, const DVec2& pixel, int width,
               int height, const RayStyle& style) {
    const Projection& projection = view.projection;
    const auto middle = projection.point(plane.point(pixel + 0.5, width, height));
    if (!middle) return;
    std::vector<Vec2> corners;
    float size = 0;
    for (const DVec2& corner : {DVec2(0, 0), DVec2(1, 0), DVec2(1, 1), DVec2(0, 1), DVec2(0, 0)}) {
        const auto at = projection.point(plane.point(pixel + corner, width, height));
        if (!at) return;
        corners.push_back(at->at);
        size = std::max(size, glm::length(at->at - middle->at));
    }
    const float least = 4 * style.scale;
    if (size < least) {
        corners.clear();
        for (const Vec2& corner : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1), Vec2(-1, -1)})
            corners.push_back(middle->at + least * corner);
    }
    sketch.paths.push_back({corners, style.ground, 3.4F * style.scale});
    sketch.paths.push_back({corners, style.highlight, 1.6F * style.scale});
}

void drawLamps(Sketch& sketch, const DepthView& view, const World& world, const RayStyle& style,
               bool labels) {
    constexpr int kRays = 8;
    for (const WorldLight& light : world.lights) {
        if (light.kind == WorldLight::Kind::Directional || light.followsCamera) continue;
        const auto at = view.projection.point(light.position);
        if (!at) continue;
        const float alpha = view.hidden(*at) ? 0.4F : 1.0F, radius = 5 * style.scale;
        const Color hue = light.emission / std::max(maxComponent(light.emission), 1e-6F);
        const Ink ink(glm::mix(Vec3(1), hue, 0.75F), alpha);
        for (int i = 0; i < kRays; ++i) {
            const float angle = 2 * kPi * (static_cast<float>(i) + 0.5F) / kRays;
            const Vec2 out(std::cos(angle), std::sin(angle));
            sketch.line(at->at + 1.45F * radius * out, at->at + 2.3F * radius * out,
                        faded(style.ground, alpha), 3.4F * style.scale);
            sketch.line(at->at + 1.45F * radius * out, at->at + 2.3F * radius * out, ink, 1.7F * style.scale);
        }
        drawDisc(sketch, at->at, radius + 1.2F * style.scale, faded(style.ground, alpha));
        drawDisc(sketch, at->at, radius, ink);
        const std::string& name = world.scene->lights[static_cast<std::size_t>(light.sceneLight)].name;
        if (labels && !name.empty() && world.lights.size() <= 4)
            sketch.labels.push_back({at->at + Vec2(0, 2.6F * radius), name, style.text, {0.5F, 0}, 0.82F});
    }
}

void drawLegend(Sketch& sketch, const std::vector<Arrow>& arrows, const RayStyle& style, const Vec2& corner) {
    std::array<int, kRayKinds> counts{};
    int blocked = 0;
    for (const Arrow& arrow : arrows) {
        ++counts[static_cast<std::size_t>(arrow.kind)];
        blocked += arrow.end == RayEnd::Blocked ? 1 : 0;
    }
    const float row = 1.35F * style.letter, line = 2.1F * style.letter;
    float y = corner.y - 0.5F * row;
    for (int kind = kRayKinds - 1; kind >= 0; --kind) {
        const auto index = static_cast<std::size_t>(kind);
        if (counts[index] == 0) continue;
        const auto rayKind = static_cast<RayKind>(kind);
        std::string text = fmt::format("{} {}", name(rayKind), counts[index]);
        if (rayKind == RayKind::Shadow && blocked > 0) text += fmt::format(", {} blocked", blocked);
        std::vector<float> dashes;
        for (const float letters : dashesOf(rayKind)) dashes.push_back(letters * style.letter);
        sketch.line({corner.x, y}, {corner.x + line, y}, faded(style.ground, 0.6F), 7 * style.scale);
        eachDash(dashes, 0, line, [&](float from, float to) {
            sketch.line({corner.x + from, y}, {corner.x + to, y}, style.kinds[index], 3 * style.scale);
        });
        sketch.labels.push_back(
            {{corner.x + line + 0.6F * style.letter, y}, text, style.kinds[index], {0, 0.5F}, 0.85F});
        y -= row;
    }
}

}
