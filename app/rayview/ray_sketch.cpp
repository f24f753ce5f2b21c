#include "app/rayview/ray_sketch.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/rayview/pen.h"
#include "core/study/palette.h"

namespace eyeray {

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

void drawLens(Sketch& sketch, const DepthView& view, const Lens& lens, const RayStyle& style) {
    constexpr int kSides = 32;
    const Pen pen{.ink = style.highlight, .width = 2 * style.scale, .dashes = {}, .tag = -1};
    const auto rim = [&](int i) {
        const float angle = 2 * kPi * static_cast<float>(i) / kSides;
        return DVec3(lens.center + lens.radius * (std::cos(angle) * lens.right + std::sin(angle) * lens.up));
    };
    for (int i = 0; i < kSides; ++i)
        if (const auto line = view.projection.line(rim(i), rim(i + 1))) drawLine(sketch, view, *line, pen);
}

void drawLegend(Sketch& sketch, const std::vector<Arrow>& arrows, const RayStyle& style, const Vec2& corner,
                std::span<const std::string_view> names) {
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
        std::string text = fmt::format("{} {}", names[index], counts[index]);
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
