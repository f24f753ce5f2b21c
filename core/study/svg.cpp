#include "core/study/svg.h"

#include <fmt/format.h>

#include <array>

#include "core/scene/base64.h"
#include "core/study/markup.h"

namespace eyeray {
namespace {

std::string attributes(const Svg::Stroke& stroke) {
    std::string result = fmt::format(R"(stroke="#{:06x}" stroke-width="{:.4g}")", stroke.color, stroke.width);
    if (stroke.opacity < 1) result += fmt::format(R"( stroke-opacity="{:.3g}")", stroke.opacity);
    for (std::size_t i = 0; i < stroke.dashes.size(); ++i)
        result += fmt::format("{}{:.4g}", i == 0 ? " stroke-dasharray=\"" : " ", stroke.dashes[i]);
    return stroke.dashes.empty() ? result : result + "\" stroke-linecap=\"round\"";
}

std::string pointList(std::span<const Vec2> points) {
    std::string result = "points=\"";
    for (const Vec2& point : points) result += fmt::format("{:.2f},{:.2f} ", point.x, point.y);
    return result + "\"";
}

std::string rectangle(Vec2 corner, Vec2 size, float radius, std::uint32_t fill) {
    return fmt::format(R"(<rect x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" rx="{:.4g}" )"
                       R"(fill="#{:06x}")",
                       corner.x, corner.y, size.x, size.y, radius, fill);
}

}

Svg::Svg(float width, float height, std::uint32_t paper)
    : body_(fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
                        R"(viewBox="0 0 {0:.0f} {1:.0f}" font-family="DejaVu Sans, Verdana, sans-serif">)"
                        "\n",
                        width, height)) {
    box({0, 0}, {width, height}, 0, paper);
}

void Svg::box(Vec2 corner, Vec2 size, float radius, std::uint32_t fill) {
    body_ += rectangle(corner, size, radius, fill) + "/>\n";
}

void Svg::box(Vec2 corner, Vec2 size, float radius, std::uint32_t fill, const Stroke& stroke) {
    body_ += rectangle(corner, size, radius, fill) + " " + attributes(stroke) + "/>\n";
}

void Svg::line(std::span<const Vec2> points, const Stroke& stroke) {
    body_ += fmt::format("<polyline {} fill=\"none\" {}/>\n", pointList(points), attributes(stroke));
}

void Svg::polygon(std::span<const Vec2> points, std::uint32_t fill, float opacity) {
    body_ += fmt::format("<polygon {} fill=\"#{:06x}\" fill-opacity=\"{:.3g}\"/>\n", pointList(points), fill,
                         opacity);
}

void Svg::image(Vec2 corner, Vec2 size, std::span<const std::byte> png) {
    body_ += fmt::format(R"(<image x="{:.2f}" y="{:.2f}" width="{:.2f}" height="{:.2f}" )"
                         R"(href="data:image/png;base64,{}"/>)"
                         "\n",
                         corner.x, corner.y, size.x, size.y, encodeBase64(png));
}

void Svg::curve(std::span<const Vec2, 4> p, const Stroke& stroke) {
    body_ +=
        fmt::format(R"(<path d="M{:.2f} {:.2f} C{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f}" fill="none" {}/>)"
                    "\n",
                    p[0].x, p[0].y, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y, attributes(stroke));
}

void Svg::text(Vec2 at, std::string_view text, const Font& font) {
    constexpr std::array kAnchors = {"start", "middle", "end"};
    std::string style = font.bold ? " font-weight=\"bold\"" : "";
    if (font.halo)
        style += fmt::format(
            R"( stroke="#{:06x}" stroke-width="{:.4g}" stroke-linejoin="round" paint-order="stroke")",
            *font.halo, font.size / 4);
    if (font.upward) style += fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", at.x, at.y);
    body_ +=
        fmt::format(R"(<text x="{:.2f}" y="{:.2f}" font-size="{:.4g}" fill="#{:06x}" text-anchor="{}"{}>)"
                    "{}</text>\n",
                    at.x, at.y, font.size, font.color, kAnchors[static_cast<std::size_t>(font.anchor)], style,
                    escaped(text));
}

void Svg::described(std::string_view hover, const std::function<void()>& draw) {
    body_ += fmt::format("<g><title>{}</title>\n", escaped(hover));
    draw();
    body_ += "</g>\n";
}

void Svg::twinColors(std::span<const std::array<std::uint32_t, 2>> lightAndDark) {
    body_ += "<style>@media screen and (prefers-color-scheme: dark) {\n";
    for (const auto& [light, dark] : lightAndDark)
        body_ += fmt::format(
            "svg [fill=\"#{0:06x}\"]{{fill:#{1:06x}}} svg [stroke=\"#{0:06x}\"]{{stroke:#{1:06x}}}\n", light,
            dark);
    body_ += "}</style>\n";
}

}
