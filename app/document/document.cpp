#include "app/document/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/document/document_commands.h"
#include "core/base/errors.h"

namespace eyeray {

Document makeDocument(std::shared_ptr<const Scene> scene) {
    Document document;
    document.camera = scene->cameras.front();
    document.aspect = document.camera.aspect;
    document.render.stop.error = kInvisibleError;
    const std::vector<std::string> lines = scene->settings;
    document.scene = std::move(scene);
    for (const std::string& line : lines) document = apply(document, Command::parse(line));
    return document;
}

BuildSettings buildSettings(const Document& document) {
    return {document.accel, isByStreams(document.render.trace.method)};
}

Document apply(const Document& document, const Command& command) {
    for (const DocumentCommand& known : documentCommands()) {
        if (known.name != command.name()) continue;
        Document changed = document;
        known.apply(changed, command);
        return changed;
    }
    throw InputError(command.text(), "there is no such command",
                     "see the list of commands on F1 or in the README");
}

std::span<const DocumentCommand> documentCommands() {
    static const std::vector<DocumentCommand> all = [] {
        std::vector<DocumentCommand> commands;
        for (const auto group : {renderingCommands(), cameraCommands(), objectCommands(), lightCommands(),
                                 materialCommands(), viewCommands(), labCommands()})
            commands.insert(commands.end(), group.begin(), group.end());
        return commands;
    }();
    return all;
}

bool isDocumentCommand(std::string_view name) {
    const auto all = documentCommands();
    return std::any_of(all.begin(), all.end(),
                       [&](const DocumentCommand& command) { return command.name == name; });
}

Scene& editableScene(Document& document) {
    auto copy = std::make_shared<Scene>(*document.scene);
    Scene& scene = *copy;
    document.scene = std::move(copy);
    return scene;
}

int detail::itemIndex(const Command& command, std::string_view key,
                      const std::vector<std::string_view>& names) {
    const std::string wanted = command.required(key);
    const auto number = toNumber(wanted);
    if (number && *number >= 0 && *number < static_cast<double>(names.size()) &&
        *number == std::floor(*number))
        return static_cast<int>(*number);
    const auto named = std::find(names.begin(), names.end(), wanted);
    if (named != names.end()) return static_cast<int>(named - names.begin());
    throw InputError(fmt::format("{} {}={}", command.name(), key, wanted),
                     fmt::format("there is no such {}", key),
                     names.empty() ? fmt::format("the scene has no {}", key)
                                   : fmt::format("give a name or a number from 0 to {}", names.size() - 1));
}

}
