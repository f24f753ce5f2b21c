#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/cli/run.h"
#include "app/viewer/bug_naming.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostShown = 8;

nlohmann::ordered_json asJson(const NamedBug& bug) {
    nlohmann::ordered_json json{{"pixels", bug.pixels}};
    if (bug.firstWrong) json["first_wrong"] = {bug.firstWrong->x, bug.firstWrong->y};
    for (const FaultMatch& match : bug.ranked)
        json["ranked"].push_back(
            {{"fault", toText(match.faults)}, {"rmse", match.rmse}, {"pixels_differ", match.differing}});
    return json;
}

}

int run(const NameBugOptions& options) {
    const Document document = openFor(options.picture).document;
    const ByteImage picture = readDisplayed(options.wrong);
    ThreadPool pool(document.threads);
    const auto world = buildWorld(document.scene, buildSettings(document));
    const NamedBug bug = *nameBug(world, document.camera, document.render, picture, pool);
    if (options.json) {
        fmt::print("{}\n", asJson(bug).dump());
        return 0;
    }
    if (bug.firstWrong)
        fmt::print("first wrong pixel {},{}\n", bug.firstWrong->x, bug.firstWrong->y);
    else
        fmt::print("no pixel is wrong\n");
    fmt::print("   rmse  pixels differ  fault\n");
    for (std::size_t i = 0; i < std::min(kMostShown, bug.ranked.size()); ++i) {
        const FaultMatch& match = bug.ranked[i];
        fmt::print("{:7.4f}  {:13}  {}\n", match.rmse, match.differing, toText(match.faults));
    }
    return 0;
}

}
