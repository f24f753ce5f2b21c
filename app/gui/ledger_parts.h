#pragma once
// What ledgerView is made of.

#include "app/gui/widgets.h"

namespace eyeray {

/// The sum, line by line, nested like the tree of rays.
void ledgerLines(const Widgets&);

/// The sum of a path as a flat list.
void pathSum(const Widgets&);

/// A square of a colour as displayed.
void swatch(const Widgets&, const Color& radiance);

}
