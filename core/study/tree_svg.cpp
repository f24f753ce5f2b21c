#include "core/study/tree_svg.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/study/palette.h"
#include "core/study/svg.h"

namespace eyeray {
namespace {

constexpr float kLetter = 24;                                // height, in units of the picture
constexpr float kMargin = 1.2F, kTitle = 1.3F, kHead = 4.2F; // in letters
constexpr float kLeastWidth = 44;
constexpr float kBar = 0.4F, kSwatch = 1.1F, kPadding = 0.4F; // in a node

class Drawing {
public:
    Drawing(const TreeDiagram& diagram, const DisplaySettings& display, bool dark)
        : diagram_(diagram), display_(display), ground_(groundOf(dark)), dark_(dark),
          svg_((std::max(diagram.width, kLeastWidth) + 2 * kMargin) * kLetter,
               (diagram.height + kHead + kMargin) * kLetter, ground_.panel) {}

    std::string draw(const std::string& title) {
        svg_.text(Vec2(kMargin, kMargin + 0.8F) * kLetter, title,
                  {.size = kTitle * kLetter, .color = ground_.text, .bold = true});
        legend();
        for (const DiagramNode& node : diagram_.nodes)
            if (node.parent >= 0) edge(node);
        for (const DiagramNode& node : diagram_.nodes) box(node);
        return svg_.file();
    }

private:
    static Vec2 placed(const Vec2& p) { return (p + Vec2(kMargin, kHead)) * kLetter; }

    void stroke(const std::array<Vec2, 4>& curve, RayKind kind, float width) {
        std::vector<float> dashes;
        for (const float length : dashesOf(kind)) dashes.push_back(length * kLetter);
        svg_.curve(curve, {colorOfKind(kind, dark_), width * kLetter, dashes});
    }

    void legend() {
        float x = kMargin;
        const float y = kMargin + 2;
        for (const RayKind kind :
             {RayKind::Eye, RayKind::Shadow, RayKind::Reflection, RayKind::Refraction, RayKind::Diffuse}) {
            if (std::none_of(diagram_.nodes.begin(), diagram_.nodes.end(),
                             [&](const DiagramNode& node) { return node.kind == kind; }))
                continue;
            const Vec2 from = Vec2(x, y) * kLetter, to = Vec2(x + 2.6F, y) * kLetter;
            stroke({from, from, to, to}, kind, 0.16F);
            svg_.text(Vec2(x + 3.2F, y + 0.35F) * kLetter, name(kind),
                      {.size = kLetter, .color = ground_.text});
            x += 10.5F;
        }
    }

    void edge(const DiagramNode& node) {
        auto curve = edgeCurve(diagram_, node);
        for (Vec2& point : curve) point = placed(point);
        stroke(curve, node.kind, node.traced ? 0.13F : 0.07F);
        if (!node.edge.empty())
            svg_.text(placed(edgeLabel(diagram_, node)), node.edge,
                      {.size = 0.85F * kLetter, .color = ground_.text, .anchor = Svg::Anchor::End});
    }

    void box(const DiagramNode& node) {
        const Vec2 corner = placed({node.x, node.y}), size = Vec2(node.width, node.height) * kLetter;
        const std::uint32_t kind = colorOfKind(node.kind, dark_);
        svg_.box(corner, size, 0.3F * kLetter, ground_.paper,
                 {node.faint ? ground_.border : kind, (node.faint ? 0.05F : 0.09F) * kLetter, {}});
        if (node.traced) {
            svg_.box(corner, {kBar * kLetter, size.y}, 0.15F * kLetter, kind);
            const Vec2 swatch(kSwatch * kLetter);
            svg_.box({corner.x + size.x - swatch.x - kPadding * kLetter, corner.y + (size.y - swatch.y) / 2},
                     swatch, 0.15F * kLetter, shownColor(node.radiance, display_),
                     {ground_.border, 0.05F * kLetter, {}});
        }
        const Svg::Font font{.size = 0.95F * kLetter, .color = node.faint ? ground_.dimmed : ground_.text};
        const float x = corner.x + (kBar + kPadding) * kLetter;
        svg_.text({x, corner.y + 1.12F * kLetter}, node.title, font);
        if (!node.detail.empty())
            svg_.text({x, corner.y + 2.35F * kLetter}, node.detail,
                      {.size = 0.85F * kLetter, .color = ground_.dimmed});
        if (node.hidden > 0)
            svg_.text({corner.x + size.x + 0.3F * kLetter, corner.y + size.y / 2 + 0.35F * kLetter},
                      fmt::format("+{}", node.hidden), {.size = kLetter, .color = ground_.dimmed});
    }

    const TreeDiagram& diagram_;
    const DisplaySettings display_;
    const Ground& ground_;
    const bool dark_;
    Svg svg_;
};

}

std::string svgOf(const TreeDiagram& diagram, const std::string& title, const DisplaySettings& display,
                  bool dark) {
    return Drawing(diagram, display, dark).draw(title);
}

}
