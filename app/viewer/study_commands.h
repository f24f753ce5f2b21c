#pragma once
// Commands for the views of the picked pixel's rays and sum; they stand in the table of viewerCommands().

#include "app/document/command.h"

namespace eyeray {

class Viewer;

void tree(Viewer&, const Command&);
void collapse(Viewer&, const Command&);
void strike(Viewer&, const Command&);
void strikePicture(Viewer&, const Command&);
void notation(Viewer&, const Command&);
void sum(Viewer&, const Command&);

}
