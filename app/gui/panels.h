#pragma once
// The panels beside the picture, one function and one file each.

#include "app/gui/widgets.h"

namespace eyeray {

void scenePanel(const Widgets&);   // built-in scenes, what to look at
void labPanel(const Widgets&);     // demonstrations of failures, their slider
void raysPanel(const Widgets&);    // method, kinds of rays, depth, cutoff
void cameraPanel(const Widgets&);  // field of view, aspect, corners of the image plane
void objectPanel(const Widgets&);  // the selected object and its material
void lightsPanel(const Widgets&);  // lamps, ambient light, sky
void displayPanel(const Widgets&); // exposure, tone mapping, when to stop
void comparePanel(const Widgets&); // the other side of a comparison, and what differs
void pixelPanel(const Widgets&);   // the picked pixel, in short
void treeView(const Widgets&);     // its rays, as a diagram or a table
void ledgerView(const Widgets&);   // its colour as a sum
void playView(const Widgets&);     // its tracing, ray by ray
void photonView(const Widgets&);   // photons from the lamps
void needsView(const Widgets&);    // what the picture needs
void statusBar(const Widgets&);    // progress and counts, one line
void noticesOverlay(const Widgets&, float right, float top); // what was done or went wrong

}
