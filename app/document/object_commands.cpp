#include <fmt/format.h>

#include <array>

#include "app/document/document_commands.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr double kFar = 1e9; // metres

Object& objectOf(Document& document, const Command& command) {
    const int index = itemIndex(command, "object", document.scene->objects);
    return editableScene(document).objects[static_cast<std::size_t>(index)];
}

void select(Document& document, const Command& command) {
    command.allowOnly({"object"});
    const std::string object = command.required("object");
    document.selectedObject = object == "none" ? -1 : itemIndex(command, "object", document.scene->objects);
}

void object(Document& document, const Command& command) {
    command.allowOnly({"object", "visible", "material", "position", "x", "y", "z"});
    const int material =
        command.find("material") ? itemIndex(command, "material", document.scene->materials) : -1;
    Object& edited = objectOf(document, command);
    edited.visible = command.flag("visible").value_or(edited.visible);
    if (material >= 0) edited.material = material;
    for (const auto& [key, axis] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}})
        edited.transform[axis] = DVec4(command.triple(key).value_or(DVec3(edited.transform[axis])), 0);
    edited.transform[3] = DVec4(command.triple("position").value_or(DVec3(edited.transform[3])), 1);
    if (!isFinite(DVec3(edited.transform[3])) || glm::length(DVec3(edited.transform[3])) > kFar)
        throw InputError(command.text(), "the object would be too far away", "keep it within 1e9 m");
}

void move(Document& document, const Command& command) {
    command.allowOnly({"object", "by"});
    command.required("by");
    Object& moved = objectOf(document, command);
    moved.transform[3] += DVec4(*command.triple("by"), 0);
    if (glm::length(DVec3(moved.transform[3])) > kFar)
        throw InputError(command.text(), "the object would be too far away", "keep it within 1e9 m");
}

constexpr std::array kCommands = {
    DocumentCommand{"select", "object=NAME|none", "Selects an object.", select},
    DocumentCommand{"object", "object=NAME visible=on|off material=NAME position=x,y,z x=… y=… z=…",
                    "Changes an object; x, y and z are the axes of its transform.", object},
    DocumentCommand{"move", "object=NAME by=x,y,z", "Moves an object.", move},
};

}

std::span<const DocumentCommand> objectCommands() { return kCommands; }

}
