#pragma once
// What ledgerView is made of.

#include "app/gui/widgets.h"

namespace eyeray {

/// The sum, line by line, nested like the tree of rays.
void ledgerLines(const Widgets&);

/// A square of a colour as displayed.
void swatch(const Widgets&, const Color& radiance);

}
