#pragma once
// The contents of the dialogs that only show text.

#include "app/gui/widgets.h"

namespace eyeray {

/// Keys, mouse and commands, from their tables.
void helpPage(const Widgets&);

/// What the import of the scene file added, mended or left out.
void importReport(const Widgets&);

}
