#include "app/cli/figures.h"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

namespace eyeray {

nlohmann::json acceleratorFigures(const World& world) {
    return {{"kind", kAccelNames[static_cast<std::size_t>(world.accelKind)]},
            {"primitives", world.primitives},
            {"nodes", world.nodes},
            {"bytes", world.bytes}};
}

std::int64_t peakRssBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

}
