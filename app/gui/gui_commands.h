#pragma once
// The table of commands that act on the window.

#include <span>
#include <string_view>

#include "app/document/command.h"

namespace eyeray {

class Gui;

struct GuiCommand {
    std::string_view name;
    std::string_view usage;
    std::string_view help;
    void (*run)(Gui&, const Command&);
};

std::span<const GuiCommand> guiCommands();

}
