#pragma once
// What treeView is made of.

#include "app/gui/widgets.h"

namespace eyeray {

void treeDiagram(const Widgets&); // fills the current window
void treeTable(const Widgets&);   // likewise
void rayDetails(const Widgets&);  // of the selected ray

/// What the index had to do for a ray of the picked sample, in a line.
std::string indexWork(const Widgets&, int ray);

/// A click on a ray of the tree.
void selectRay(const Widgets&, int ray);

}
