#pragma once
// What is under the pointer: the pixel's colour, what it shows and which rays it takes, before any click.

#include <chrono>

#include "app/gui/widgets.h"

namespace eyeray {

/// A pixel of the picture shown, its first sample traced again.
struct HoveredPixel {
    PixelPosition pixel;
    Retrace trace;
};

class HoverView {
public:
    /// The pointer is over this pixel of a picture that has not changed as long as `version` is the same.
    /// Traces its sample, but no more often than leaves the window four fifths of its time.
    void over(Viewer&, PixelPosition, std::uint64_t version);
    void leave();

    /// The pixel traced last; nothing if the pointer is elsewhere.
    const std::optional<HoveredPixel>& pixel() const { return hovered_; }
    /// True if the pixel under the pointer is still to be traced.
    bool pending() const { return pending_; }

    /// A few lines beside the pointer, towards the middle of the picture. `shown`: the pixel's colour on the
    /// screen; `layer`: what a layer says of it, if one is shown.
    void draw(const Widgets&, ImVec2 pictureMiddle, const Rgba8& shown, const std::string& layer) const;

private:
    using Clock = std::chrono::steady_clock;

    std::optional<HoveredPixel> hovered_;
    std::uint64_t version_ = 0;
    bool pending_ = false;
    Clock::time_point rested_; // when the next may be traced
};

/// Names of what a ray meets and its material, and the distance: "knot, gold, t = 4.754 m".
std::string metText(const Scene&, const RayRecord&);

}
