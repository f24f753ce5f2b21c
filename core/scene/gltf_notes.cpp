#include "core/scene/gltf_notes.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_limits.h"

namespace eyeray {

void GltfNotes::write(ImportReport::Kind kind, const std::string& text) {
    constexpr std::size_t kLineBytes = 400;
    if (report_.lines.size() < limits::kReportLines)
        report_.lines.push_back({kind, printable(text, kLineBytes)});
    else
        ++dropped_;
}

void GltfNotes::finish() {
    for (const auto& [what, count] : counts_) {
        const auto& [feature, owner] = what;
        ignored(fmt::format("{} of {} {}{} is not shown", feature, count, owner, count == 1 ? "" : "s"));
    }
    if (dropped_ > 0)
        report_.lines.push_back(
            {ImportReport::Kind::Ignored, fmt::format("and {} more lines like these", dropped_)});
}

double clamped(double value, double lo, double hi, const std::string& what, GltfNotes& notes) {
    if (value >= lo && value <= hi) return value;
    const double result = value > hi ? hi : lo;
    notes.repaired(fmt::format("{} is {:g}, taken as {:g}", what, value, result));
    return result;
}

}
