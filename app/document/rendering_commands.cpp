#include <fmt/format.h>

#include <array>

#include "app/document/document_commands.h"
#include "app/document/settings.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

void set(Document& document, const Command& command) {
    if (command.arguments().empty())
        throw InputError("set", "nothing to set", "write set key=value, such as: set max-depth=5");
    for (const auto& [key, value] : command.arguments()) settingNamed(key).set(document, command, key);
}

/// The lectures' ladder: 1 Phong, 2 and shadow rays, 3 and reflection, 4 and transmission.
void step(Document& document, const Command& command) {
    command.allowOnly({"n"});
    command.required("n");
    const int n = *command.integer("n", 1, 4);
    TraceSettings& trace = document.render.trace;
    trace.method = Method::Whitted;
    trace.shadows = n >= 2;
    trace.reflections = n >= 3;
    trace.refractions = n >= 4;
}

void toggle(Document& document, const Command& command) {
    command.allowOnly({"key"});
    const std::string key = command.required("key");
    const Setting& setting = settingNamed(key);
    const std::string value = setting.get(document);
    if (value != "on" && value != "off")
        throw InputError(command.text(), fmt::format("{} is not on or off", key),
                         "toggle shadows, reflections or refractions");
    setting.set(document, {"set", {{key, value == "on" ? "off" : "on"}}}, key);
}

/// Adds to a number; at the end of its range it stays there.
void adjust(Document& document, const Command& command) {
    command.allowOnly({"key", "by"});
    const std::string key = command.required("key");
    command.required("by");
    const double by = *command.number("by", -1e6, 1e6);
    const Setting& setting = settingNamed(key);
    const auto value = toNumber(setting.get(document));
    if (!value)
        throw InputError(command.text(), fmt::format("{} is no number", key),
                         "adjust max-depth, fov or exposure");
    Document changed = document;
    try {
        setting.set(changed, {"set", {{key, toText(*value + by)}}}, key);
    } catch (const InputError&) {
        return;
    }
    document = changed;
}

/// One mistake on or off; the setting of that name says all at once.
void fault(Document& document, const Command& command) {
    command.allowOnly({"name", "on"});
    const Fault fault = faultNamed(command.required("name"));
    FaultSet& faults = document.render.trace.faults;
    faults.set(fault, command.flag("on").value_or(!faults.has(fault)));
}

constexpr std::array kCommands = {
    DocumentCommand{"set", "key=value …", "Changes settings.", set},
    DocumentCommand{"toggle", "key=KEY", "Switches a setting on or off.", toggle},
    DocumentCommand{"adjust", "key=KEY by=N", "Adds to a setting.", adjust},
    DocumentCommand{"fault", "name=NAME on=on|off", "Makes a well-known mistake, or no longer.", fault},
    DocumentCommand{"step", "n=1…4", "Phong; and shadow rays; and reflection; and transmission.", step},
};

}

std::span<const DocumentCommand> renderingCommands() { return kCommands; }

}
