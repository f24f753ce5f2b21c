// No more than the picture needs: measured, applied, checked.

#include <fmt/format.h>

#include "app/viewer/viewer.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

bool sameModel(const Document& a, const Document& b) {
    return a.scene == b.scene && a.camera == b.camera && commandsBetween(a, b).empty();
}

}

bool Viewer::needsHold() const { return needs_.needs() && sameModel(needs_.before(), document()); }
bool Viewer::needsApplied() const { return needs_.needs() && sameModel(needs_.after(), document()); }

void Viewer::measureNeeds() {
    if (width_ <= 0 || height_ <= 0)
        throw InputError("measure-needs", "there is no picture yet", "wait a moment");
    applyNeeds_ = false;
    needs_.measure(document(), width_, height_, document().threads > 0 ? document().threads : threads_);
}

void Viewer::applyNeeds() {
    if (needsApplied() && !needsHold())
        return report(Notice::Kind::Done, "the picture is made with no more than it needs already");
    if (needsHold()) return applyMeasured();
    measureNeeds();
    applyNeeds_ = true;
    report(Notice::Kind::Done, "measuring what the picture needs");
}

void Viewer::applyMeasured() {
    applyNeeds_ = false;
    if (needsApplied()) return report(Notice::Kind::Done, "the picture needs all that is set");
    change(withNeeded(document(), *needs_.needs()), {});
    report(Notice::Kind::Done, "no more than the picture needs: " + summaryText(*needs_.needs()));
    needs_.check();
}

void Viewer::reportChecked(const MeasuredNeeds& before) {
    std::string text;
    for (const NeedItem& item : needs_.needs()->items)
        if (!item.takenBack.empty())
            text += fmt::format("{}{}: {}", text.empty() ? "taken back, " : "; ", item.what, item.takenBack);
    if (text.empty() && before.needed.samples < needs_.needs()->needed.samples)
        text =
            fmt::format("taken back, samples: {} are too few for the whole picture", before.needed.samples);
    report(text.empty() ? Notice::Kind::Done : Notice::Kind::Warning,
           text.empty() ? "checked in the whole picture: " + summaryText(*needs_.needs()) : text);
}

bool Viewer::updateNeeds() {
    if (!needs_.running()) return false;
    const std::optional<MeasuredNeeds> former = needs_.needs();
    const bool asApplied = needsApplied();
    try {
        if (!needs_.update()) return true;
    } catch (const std::exception& error) {
        needs_.clear();
        report(Notice::Kind::Error, error.what());
        return true;
    }
    if (!needs_.checked()) {
        if (applyNeeds_ && needsHold()) applyMeasured();
        return true;
    }
    if (!asApplied) return true; // edited since: what was found is no longer asked for
    history_->replace(withNeeded(document(), *needs_.needs())); // of the same step
    reportChecked(*former);
    return true;
}

}
