#pragma once
// The rays of many pixels at once.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "app/viewer/viewer.h"

namespace eyeray {

/// Whose rays are shown: those of the picked pixel, or of every few pixels of its row, its column or the
/// whole picture.
enum class ShownRays : std::uint8_t { Pixel, Row, Column, Grid };
inline constexpr std::array<std::string_view, 4> kShownRaysNames = {"pixel", "row", "column", "grid"};

/// Samples of pixels of the viewer's picture, traced again.
class TracedPixels {
public:
    /// Traces them when something that they show has changed: every `step`-th pixel (0: so that the rays stay
    /// apart) through the picked one, or through the middle if none is picked. The picked one is left out,
    /// and so is what would be too much to see.
    void update(Viewer&, ShownRays, int step);

    const std::vector<Retrace>& samples() const { return samples_; }
    std::size_t wanted() const { return wanted_; } // pixels: more than there are samples if some are left out

private:
    /// What they were traced for.
    struct TracedFor {
        std::shared_ptr<const World> world;
        Camera camera;
        TraceSettings trace;
        int width = 0, height = 0, sample = 0, step = 0;
        PixelPosition pixel;
        ShownRays show = ShownRays::Pixel;
        bool ready = false; // the picture that is shown is that of the world
        friend bool operator==(const TracedFor&, const TracedFor&) = default;
    };

    std::vector<Retrace> samples_;
    std::size_t wanted_ = 0;
    std::optional<TracedFor> tracedFor_;
};

}
