#include "app/viewer/switched_kind.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/study/wording.h"

namespace eyeray {

std::optional<std::string> switchedKind(const RenderSettings& before, const RenderSettings& now) {
    constexpr std::array kSwitches = {std::pair{"shadows", &TraceSettings::shadows},
                                      std::pair{"reflections", &TraceSettings::reflections},
                                      std::pair{"refractions", &TraceSettings::refractions}};
    for (const auto& [key, field] : kSwitches) {
        RenderSettings takenBack = now;
        takenBack.trace.*field = before.trace.*field;
        if (takenBack.trace != now.trace && takenBack == before)
            return fmt::format("{}={}", key, before.trace.*field ? "on" : "off");
    }
    return std::nullopt;
}

std::string switchText(const std::string& takesBack, const PictureChange& change) {
    const std::size_t equals = takesBack.find('=');
    const auto ours = change.here.total(), theirs = change.there.total();
    return fmt::format("{} rays {}: {} rays {}, {:.1f} % of pixels changed", takesBack.substr(0, equals - 1),
                       takesBack.substr(equals + 1) == "on" ? "off" : "on",
                       countText(ours < theirs ? theirs - ours : ours - theirs),
                       ours < theirs ? "fewer" : "more",
                       100.0 * static_cast<double>(change.changed) / static_cast<double>(change.pixels));
}

}
