#pragma once
// The ray tree as a picture for slides.

#include <string>

#include "core/render/display.h"
#include "core/study/tree_diagram.h"

namespace eyeray {

/// The diagram under a title, with a legend of the kinds that occur. Colours of light are shown by `display`.
std::string svgOf(const TreeDiagram&, const std::string& title, const DisplaySettings& display, bool dark);

}
