#include "core/base/fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/errors.h"

namespace eyeray {

std::string toText(FaultSet faults) {
    std::string text;
    for (int i = 0; i < kFaults; ++i)
        if (const auto fault = static_cast<Fault>(i); faults.has(fault))
            text += fmt::format("{}{}", text.empty() ? "" : ",", describe(fault).name);
    return text.empty() ? "none" : text;
}

Fault faultNamed(std::string_view name) {
    const auto* const found = std::find_if(kFaultNames.begin(), kFaultNames.end(),
                                           [&](const FaultName& known) { return known.name == name; });
    if (found != kFaultNames.end()) return static_cast<Fault>(found - kFaultNames.begin());
    std::string known;
    for (const FaultName& fault : kFaultNames) known += fmt::format(" {}", fault.name);
    throw InputError(fmt::format("fault {}", name), "there is no such fault", "use one of" + known);
}

FaultSet faultsNamed(std::string_view text) {
    FaultSet faults;
    if (text == "none") return faults;
    while (true) {
        const std::size_t comma = std::min(text.find(','), text.size());
        faults.set(faultNamed(text.substr(0, comma)), true);
        if (comma == text.size()) return faults;
        text.remove_prefix(comma + 1);
    }
}

}
