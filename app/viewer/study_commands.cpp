#include "app/viewer/study_commands.h"

#include <algorithm>

#include "app/viewer/strike_picture.h"
#include "app/viewer/viewer.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr int kMostTerms = 1 << 24;

void needPicked(const Viewer& viewer, const Command& command) {
    if (!viewer.picked())
        throw InputError(command.text(), "no pixel is picked", "click the picture, or say pick x=320 y=240");
}

}

void tree(Viewer& viewer, const Command& command) {
    constexpr std::array kShown = {"diagram"sv, "table"sv};
    constexpr std::array kKinds = {"eye"sv,        "shadow"sv,  "reflection"sv,
                                   "refraction"sv, "diffuse"sv, "untraced"sv};
    command.allowOnly({"show", "kind", "on", "least-weight"});
    StudySettings settings = viewer.study().settings();
    if (const auto shown = command.choice("show", kShown)) settings.table = *shown == 1;
    if (const auto kind = command.choice("kind", kKinds)) {
        const auto k = static_cast<std::size_t>(*kind);
        bool& shows = k < kRayKinds ? settings.filter.kinds[k] : settings.filter.untraced;
        shows = command.flag("on").value_or(!shows);
    }
    if (const auto least = command.number("least-weight", 0, 1))
        settings.filter.leastWeight = static_cast<float>(*least);
    viewer.setStudy(settings);
}

void collapse(Viewer& viewer, const Command& command) {
    command.allowOnly({"ray", "on"});
    command.required("ray");
    const int ray = *command.integer("ray", 0, kMaxTreeNodes * 2);
    StudySettings settings = viewer.study().settings();
    auto& collapsed = settings.filter.collapsed;
    const auto place = std::lower_bound(collapsed.begin(), collapsed.end(), ray);
    const bool now = place != collapsed.end() && *place == ray;
    const bool wanted = command.flag("on").value_or(!now);
    if (wanted && !now) collapsed.insert(place, ray);
    if (!wanted && now) collapsed.erase(place);
    viewer.setStudy(settings);
}

void strike(Viewer& viewer, const Command& command) {
    command.allowOnly({"term", "on"});
    needPicked(viewer, command);
    const auto term = command.integer("term", 0, kMostTerms);
    if (!term) return viewer.restoreStruck();
    viewer.strike(*term, command.flag("on").value_or(!viewer.study().isStruck(*term)));
}

void strikePicture(Viewer& viewer, const Command& command) {
    command.allowOnly({});
    needPicked(viewer, command);
    const auto commands = strikesEverywhere(viewer.study(), viewer.picked()->trace, *viewer.document().scene);
    if (commands.empty())
        throw InputError(command.text(), "nothing is struck out", "strike a term out first: strike term=N");
    for (const Command& change : commands) viewer.execute(change, "strike-picture");
    viewer.endGesture();
}

void notation(Viewer& viewer, const Command& command) {
    command.allowOnly({"name"});
    command.required("name");
    StudySettings settings = viewer.study().settings();
    settings.notation = static_cast<Notation>(*command.choice("name", kNotationNames));
    viewer.setStudy(settings);
}

void sum(Viewer& viewer, const Command& command) {
    constexpr std::array kShown = {"nested"sv, "flat"sv};
    command.allowOnly({"show"});
    command.required("show");
    StudySettings settings = viewer.study().settings();
    settings.flatSum = *command.choice("show", kShown) == 1;
    viewer.setStudy(settings);
}

}
