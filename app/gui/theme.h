#pragma once
// How the window looks.

#include <imgui.h>

#include "core/base/ray_kind.h"

namespace eyeray {

/// Colours and measures of the dark or the light theme, at scale 1.
ImGuiStyle themeStyle(bool dark);

/// Colour of a kind of ray, the same in every view: colorOfKind.
ImVec4 colorOf(RayKind, bool dark);

/// A colour of core/study/palette.h.
ImVec4 fromHex(std::uint32_t hex, float alpha = 1);

/// Colours for what needs attention.
ImVec4 errorColor(bool dark);
ImVec4 doneColor(bool dark);

}
