#pragma once
// How the middle of the window is shared out.

#include <optional>

#include <imgui.h>

namespace eyeray {

/// A rectangle of the window, in pixels.
struct Area {
    ImVec2 at, size;
};

/// Where the views of the middle stand; what has no place is not shown.
struct ExplainLayout {
    Area picture;
    std::optional<Area> rays, words;
};

/// Above the picture and the rays in space, side by side or, where that is too narrow, one above the other;
/// below them the words and numbers, where there is height for them. In a very small middle the picture
/// alone. `letter` is the height of the window's text.
ExplainLayout explainLayout(const Area& middle, float letter);

}
