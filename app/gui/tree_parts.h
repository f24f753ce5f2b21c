#pragma once
// What treeView is made of.

#include "app/gui/widgets.h"

namespace eyeray {

void treeDiagram(const Widgets&); // fills the current window
void treeTable(const Widgets&);   // likewise
void rayDetails(const Widgets&);  // of the selected ray

/// A click on a ray of the tree.
void selectRay(const Widgets&, int ray);

}
