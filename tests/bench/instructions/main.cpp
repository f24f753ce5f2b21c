// eyeray_instructions_bench SCENE INDEX KIND TIMES: sends the rays of a kind through a scene as often, alone
// and on one thread, and says how many they are and which instruction set they took. For instructions.sh,
// which counts; what two counts of different TIMES have in common is not the rays.

#include <fmt/format.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cstdlib>
#include <span>

#include "app/document/scene_files.h"
#include "core/base/errors.h"
#include "core/study/ray_bench.h"

namespace eyeray::bench {
namespace {

constexpr int kSide = 64; // of the picture whose rays are traced

AccelKind accelNamed(std::string_view name) {
    const auto found = std::ranges::find(kAccelNames, name);
    ENSURE(found != kAccelNames.end());
    return static_cast<AccelKind>(found - kAccelNames.begin());
}

void run(const std::string& scene, std::string_view index, std::string_view kind, int times) {
    const Document document = openScene(scene).document;
    const auto world = buildWorld(document.scene, {accelNamed(index)});
    const std::vector<RaySet> sets = raySets(*world, document.camera, kSide);
    const auto set = std::ranges::find(sets, kind, [](const RaySet& s) { return name(s.kind); });
    ENSURE(set != sets.end());
    ThreadPool pool(1);
    for (int i = 0; i < times; ++i) trace(*world->accel, *set, pool);
    fmt::print("{} {}\n", set->rays.size(), hwy::TargetName(hwy::SupportedAndGeneratedTargets().front()));
}

}
}

int main(int argc, char** argv) {
    const std::span arguments(argv, static_cast<std::size_t>(argc));
    if (arguments.size() != 5) {
        fmt::print(stderr, "usage: eyeray_instructions_bench SCENE INDEX KIND TIMES\n");
        return 2;
    }
    try {
        eyeray::bench::run(arguments[1], arguments[2], arguments[3], std::atoi(arguments[4]));
    } catch (const std::exception& error) {
        fmt::print(stderr, "eyeray_instructions_bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
