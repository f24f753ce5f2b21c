#pragma once
// Commands for the live chart; they stand in the table of viewerCommands().

#include "app/document/command.h"

namespace eyeray {

class Viewer;

void curve(Viewer&, const Command&);
void curveReturn(Viewer&, const Command&);
void curveRemove(Viewer&, const Command&);
void chartReference(Viewer&, const Command&);
void chartSave(Viewer&, const Command&);

}
