#include "app/gui/layer_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/study/color_map.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostObjects = 8; // in a legend

ImU32 toImColor(const Rgba8& c) { return IM_COL32(c.r, c.g, c.b, 255); }

/// Round numbers in a range: from two to six of them.
std::vector<double> linearTicks(const LayerRange& range) {
    const double span = range.highest - range.lowest;
    const double power = std::pow(10.0, std::floor(std::log10(span)));
    double step = power;
    for (const double finer : {0.5, 0.2})
        if (span / step < 3) step = power * finer;
    std::vector<double> ticks;
    const auto first = std::lround(std::ceil(range.lowest / step));
    const auto last = std::lround(std::floor(range.highest / step + 1e-9));
    for (auto i = first; i <= last; ++i) ticks.push_back(static_cast<double>(i) * step);
    return ticks;
}

/// 1, 2 and 5 in each power of ten; over more than two powers, 1 alone.
std::vector<double> logarithmicTicks(const LayerRange& range) {
    std::vector<double> ticks;
    const bool wide = range.highest > 100 * range.lowest;
    const auto powerBelow = [](double value) { return std::lround(std::floor(std::log10(value))); };
    for (auto power = powerBelow(range.lowest); power <= powerBelow(range.highest); ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double tick = digit * std::pow(10.0, power);
            if (tick >= range.lowest && tick <= range.highest && (digit == 1 || !wide)) ticks.push_back(tick);
        }
    return ticks;
}

}

void LayerView::refresh(const Viewer& viewer) {
    const bool counts = shownLayer(viewer.document()).quantity == Quantity::Samples;
    const RenderSession& session = viewer.session();
    const std::shared_ptr<const LayerFilm> film = counts ? nullptr : viewer.layers().film();
    const std::optional<FilmPixel> counted = counts ? session.pixel(0, 0) : std::nullopt;
    const Shown now{film, counted ? counted->film : 0, film ? film->passes() : session.status().samples,
                    shownDisplay(viewer.document().render)};
    if (now == shown_) return;
    std::optional<LayerImage> image = viewer.layerImage();
    showing_ = image.has_value();
    if (!image) return;
    shown_ = now;
    image_ = *std::move(image);
    const Quantity quantity = image_.layer.quantity;
    range_ = hasRange(quantity) ? rangeOf(image_) : LayerRange{};
    texture_.upload(displayLayer(image_, range_, now.display));
    if (quantity == Quantity::Object) countObjects();
}

void LayerView::countObjects() {
    std::vector<std::size_t> pixels;
    for (const Color& id : image_.values.values()) {
        if (id.x < 0) continue;
        const auto i = static_cast<std::size_t>(id.x);
        if (i >= pixels.size()) pixels.resize(i + 1);
        ++pixels[i];
    }
    objects_.resize(pixels.size());
    std::iota(objects_.begin(), objects_.end(), 0);
    std::erase_if(objects_, [&](int i) { return pixels[static_cast<std::size_t>(i)] == 0; });
    const auto size = [&](int i) { return pixels[static_cast<std::size_t>(i)]; };
    std::sort(objects_.begin(), objects_.end(),
              [&](int a, int b) { return std::pair(size(b), a) < std::pair(size(a), b); });
}

std::string LayerView::textAt(double across, double down) const {
    const Color value = image_.values.at(static_cast<int>(across * image_.values.width()),
                                         static_cast<int>(down * image_.values.height()));
    const Quantity quantity = image_.layer.quantity;
    const bool one = hasRange(quantity) || quantity == Quantity::Object;
    return fmt::format("{}: {}", image_.layer.name,
                       one ? valueText(quantity, static_cast<double>(value.x)) : colorText(value));
}

void LayerView::legend(const Widgets& ui, const LegendPlace& place) const {
    legendPane(ui, "layer legend", place, [&] {
        const Quantity quantity = image_.layer.quantity;
        ImGui::TextUnformatted(image_.layer.name.c_str());
        ImGui::SameLine();
        if (quantity == Quantity::Samples)
            ImGui::TextDisabled("%.1f a pixel on average", ui.viewer.status().samplesPerPixel);
        else
            ImGui::TextDisabled("%d of %d samples", image_.samples, ui.viewer.layers().samplesInAll());
        ImGui::TextWrapped("%s", aboutLayer(image_.layer).c_str());
        if (hasRange(quantity)) colorBar(std::min(ImGui::GetFontSize() * 22, place.width * 0.7F));
        if (quantity == Quantity::Object) objects(*ui.viewer.document().scene, place.height);
    });
}

void LayerView::objects(const Scene& scene, float height) const {
    const float lines = 0.5F * height / ImGui::GetTextLineHeightWithSpacing() - 3; // beside these
    const auto shown =
        std::min({objects_.size(), kMostObjects, static_cast<std::size_t>(std::max(1.0F, lines))});
    for (std::size_t i = 0; i < shown; ++i)
        swatch(objectColor(objects_[i]), fmt::format("{} {}", objects_[i], objectName(scene, objects_[i])));
    if (objects_.size() > shown)
        ImGui::TextDisabled("and %d more", static_cast<int>(objects_.size() - shown));
}

void LayerView::colorBar(float width) const {
    const Quantity quantity = image_.layer.quantity;
    const float letter = ImGui::GetFontSize(), side = 0.8F * letter; // room for the numbers at its ends
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float left = start.x + side, length = width - 2.5F * side;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int steps = static_cast<int>(length);
    for (int i = 0; i < steps; ++i) {
        const float x = left + static_cast<float>(i);
        const double value = valueAt(range_, quantity, (i + 0.5) / steps);
        list.AddRectFilled({x, start.y}, {x + 1, start.y + letter},
                           toImColor(rangeColor(quantity, value, range_)));
    }
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
    list.AddRect({left - 1, start.y - 1}, {left + static_cast<float>(steps) + 1, start.y + letter + 1},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled));
    for (const double tick : isLogarithmic(quantity) ? logarithmicTicks(range_) : linearTicks(range_)) {
        const float x = left + static_cast<float>(placeIn(range_, quantity, tick)) * length;
        const std::string text = fmt::format("{:.4g}", tick);
        list.AddLine({x, start.y + letter}, {x, start.y + 1.3F * letter}, ink);
        list.AddText({x - ImGui::CalcTextSize(text.c_str()).x / 2, start.y + 1.3F * letter}, ink,
                     text.c_str());
    }
    ImGui::Dummy({width, 2.4F * letter});
    const std::string end =
        fmt::format("{} to {}{}", valueText(quantity, range_.lowest), valueText(quantity, range_.highest),
                    range_.cut ? ", a few pixels beyond" : "");
    ImGui::TextDisabled("%s", end.c_str());
}

}
