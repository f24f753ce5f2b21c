#pragma once
// The table of commands that act on the viewer rather than on its document.

#include <span>
#include <string_view>

#include "app/document/command.h"

namespace eyeray {

class Viewer;

struct ViewerCommand {
    std::string_view name;
    std::string_view usage;
    std::string_view help;
    void (*run)(Viewer&, const Command&);
};

std::span<const ViewerCommand> viewerCommands();

/// Throws InputError for a command or argument it does not know, and whatever the command throws.
void executeViewerCommand(Viewer&, const Command&);

}
