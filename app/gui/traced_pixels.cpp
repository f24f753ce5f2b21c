#include "app/gui/traced_pixels.h"

#include <algorithm>

#include "app/rayview/ray_view.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostPixels = 200; // whose rays are shown at once
constexpr int kPixelsInLine = 24;        // of a row or column, if no step is given
constexpr int kPixelsInGrid = 9;         // along the longer side, likewise

/// Every `step`-th pixel of a line of `count`, so that `through` is one of them.
std::vector<int> everyStep(int count, int step, int through) {
    std::vector<int> places;
    for (int place = through % step; place < count; place += step) places.push_back(place);
    return places;
}

std::vector<PixelPosition> pixelsOf(ShownRays show, int step, PixelPosition picked, PictureSize size) {
    const std::vector<int> columns =
        show == ShownRays::Column ? std::vector{picked.x} : everyStep(size.width, step, picked.x);
    const std::vector<int> rows =
        show == ShownRays::Row ? std::vector{picked.y} : everyStep(size.height, step, picked.y);
    std::vector<PixelPosition> pixels;
    for (const int y : rows)
        for (const int x : columns)
            if (PixelPosition{x, y} != picked) pixels.push_back({x, y});
    return pixels;
}

int stepFor(ShownRays show, PictureSize size) {
    const int along = show == ShownRays::Column ? size.height
                      : show == ShownRays::Row  ? size.width
                                                : std::max(size.width, size.height);
    return std::max(1, along / (show == ShownRays::Grid ? kPixelsInGrid : kPixelsInLine));
}

}

void TracedPixels::update(Viewer& viewer, ShownRays show, int step) {
    if (show == ShownRays::Pixel) {
        samples_.clear();
        tracedFor_.reset();
        return;
    }
    const PictureSize size = viewer.pictureSize();
    const auto& picked = viewer.picked();
    const PixelPosition pixel = picked ? picked->pixel : PixelPosition{size.width / 2, size.height / 2};
    TracedFor now{.world = viewer.shownWorld(),
                  .camera = viewer.document().camera,
                  .trace = viewer.document().render.trace,
                  .width = size.width,
                  .height = size.height,
                  .sample = picked ? picked->sample : 0,
                  .step = step > 0 ? step : stepFor(show, size),
                  .pixel = pixel,
                  .show = show,
                  .ready = viewer.status().phase != RenderStatus::Phase::Coarse};
    if (now == tracedFor_) return;
    samples_.clear();
    const auto pixels = pixelsOf(show, now.step, pixel, size);
    wanted_ = pixels.size();
    std::size_t rays = picked ? picked->trace.rays.size() : 0;
    for (const PixelPosition& p : pixels) {
        if (samples_.size() >= kMostPixels) break;
        auto trace = viewer.session().retrace(p.x, p.y, now.sample);
        if (!trace) continue;
        rays += trace->rays.size();
        if (rays > kMostArrows) break;
        samples_.push_back(std::move(*trace));
    }
    tracedFor_ = std::move(now);
}

}
