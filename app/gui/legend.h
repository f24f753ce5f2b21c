#pragma once
// Words and colours over a corner of the picture.

#include <functional>

#include "app/gui/widgets.h"
#include "core/image/pixels.h"

namespace eyeray {

/// Where legends stand: the lower left corner of the picture, and its size.
struct LegendPlace {
    ImVec2 corner;
    float width, height;
};

/// A pane that takes no clicks, as large as what `content` draws.
void legendPane(const Widgets&, const char* name, const LegendPlace&, const std::function<void()>& content);

/// A square of a colour, as high as a letter, and a text beside it.
void swatch(const Rgba8& color, const std::string& text);

}
