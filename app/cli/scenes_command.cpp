#include <fmt/format.h>

#include <algorithm>

#include "app/cli/run.h"
#include "core/base/errors.h"

namespace eyeray {

int run(const ScenesOptions&) {
    const auto scenes = builtinScenes();
    if (scenes.empty())
        throw Failure(assetsFolder().string(), "the built-in scenes are missing", "install Eyeray again");
    std::size_t widest = 0;
    for (const BuiltinScene& scene : scenes) widest = std::max(widest, scene.name.size());
    for (const LabDemo& demo : labDemos()) widest = std::max(widest, demo.name.size());
    for (const BuiltinScene& scene : scenes)
        fmt::print("{:<{}}  {}\n", scene.name, widest, scene.whatToLookAt);
    for (const LabDemo& demo : labDemos()) fmt::print("{:<{}}  {}\n", demo.name, widest, demo.why);
    return 0;
}

}
