#pragma once
// The table of commands that change a Document.

#include <span>
#include <string_view>

#include "app/document/document.h"

namespace eyeray {

struct DocumentCommand {
    std::string_view name;
    std::string_view usage; // its arguments
    std::string_view help;  // one line
    /// Changes the document; throws InputError for a wrong argument and may then leave it half changed.
    void (*apply)(Document&, const Command&);
};

std::span<const DocumentCommand> documentCommands();

/// True if `name` is one of documentCommands().
bool isDocumentCommand(std::string_view name);

// By noun, one file each.
std::span<const DocumentCommand> renderingCommands(); // set toggle adjust step fault
std::span<const DocumentCommand> cameraCommands();    // camera orbit pan dolly fly frame
std::span<const DocumentCommand> objectCommands();    // select object move
std::span<const DocumentCommand> lightCommands();     // light add-light remove-light ambient environment
std::span<const DocumentCommand> materialCommands();  // material
std::span<const DocumentCommand> viewCommands();      // layer compare
std::span<const DocumentCommand> labCommands();       // lab mark-wrong

/// Index from `key=`: a number, else the name of one of `items`. Throws InputError if there is none.
template <class Items>
int itemIndex(const Command&, std::string_view key, const Items& items);

/// A lamp as add-light makes it, but for its place.
Light addedLight(std::string name);

/// A copy of the document's scene to edit; it becomes the document's scene.
Scene& editableScene(Document&);

namespace detail {
int itemIndex(const Command&, std::string_view key, const std::vector<std::string_view>& names);
}

template <class Items>
int itemIndex(const Command& command, std::string_view key, const Items& items) {
    std::vector<std::string_view> names;
    names.reserve(items.size());
    for (const auto& item : items) names.push_back(item.name);
    return detail::itemIndex(command, key, names);
}

}
