#pragma once
// Lines and discs of a flat drawing that know what the scene hides.

#include <numeric>
#include <vector>

#include "app/rayview/depth_view.h"
#include "app/rayview/sketch.h"

namespace eyeray {

inline constexpr float kHiddenAlpha = 0.3F; // of what is hidden behind the scene

inline Ink faded(Ink ink, float by) {
    ink.a *= by;
    return ink;
}

struct Pen {
    Ink ink;
    float width;
    std::vector<float> dashes; // pixels: dash, gap, …; none for a full line
    bool fades = false;        // towards its end
    int tag = -1;
};

/// Calls piece(from, to) for each dash of a line's part [from, to], pixels along the line.
template <class Piece>
void eachDash(const std::vector<float>& dashes, float from, float to, const Piece& piece) {
    const float period = std::accumulate(dashes.begin(), dashes.end(), 0.0F);
    if (!(period > 0)) return piece(from, to);
    for (int n = static_cast<int>(from / period); static_cast<float>(n) * period < to; ++n) {
        float at = static_cast<float>(n) * period;
        for (std::size_t i = 0; i + 1 < dashes.size(); i += 2) {
            const float lo = std::max(from, at), hi = std::min(to, at + dashes[i]);
            if (hi > lo) piece(lo, hi);
            at += dashes[i] + dashes[i + 1];
        }
    }
}

/// Draws a line, faint where it is hidden.
void drawLine(Sketch&, const DepthView&, const ScreenLine&, const Pen&);

void drawDisc(Sketch&, const Vec2& at, float radius, const Ink&, int tag = -1);

}
