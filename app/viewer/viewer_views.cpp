// What the viewer shows besides its picture: layers, the other side of a comparison, photons.

#include <fmt/format.h>

#include "app/viewer/switched_kind.h"
#include "app/viewer/viewer.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr int kLayerSamples = 16; // smooth edges; more would show little more

}

bool Viewer::updateLayer() {
    const Layer layer = shownLayer(document());
    const bool hasTracing = layer.quantity != Quantity::Picture && layer.quantity != Quantity::Samples;
    if (!hasTracing || !rendered_) {
        layers_.clear();
        return false;
    }
    RenderSettings settings = *rendered_;
    settings.display = {};
    settings.stop = {.samples = std::min(settings.stop.samples, kLayerSamples), .seconds = 0, .error = 0};
    layers_.show({layer, renderedWorld_, renderedCamera_, settings, sessionThreads_});
    try {
        return layers_.update();
    } catch (const std::exception& error) {
        report(Notice::Kind::Error, error.what());
        return true;
    }
}

std::optional<LayerImage> Viewer::layerImage() const {
    const Layer layer = shownLayer(document());
    if (layer.quantity != Quantity::Samples)
        return layers_.film() ? std::optional(layers_.film()->image(0)) : std::nullopt;
    ColorImage counts = session_->sampleCounts();
    if (counts.empty()) return std::nullopt;
    return LayerImage{layer, session_->status().samples, std::move(counts)};
}

bool Viewer::updatePhotons() {
    if (!photonSettings_.on || !rendered_ || !renderedWorld_) {
        photons_.clear();
        return false;
    }
    photons_.show({.world = renderedWorld_,
                   .camera = renderedCamera_,
                   .width = rendered_->width,
                   .height = rendered_->height,
                   .radius = lensRadius(photonSettings_, renderedCamera_),
                   .threads = sessionThreads_,
                   .seed = rendered_->seed},
                  photonSettings_);
    try {
        return photons_.update();
    } catch (const std::exception& error) {
        report(Notice::Kind::Error, error.what());
        photonSettings_.on = false;
        return true;
    }
}

void Viewer::nameBug(const std::filesystem::path& picture) {
    finishJobs();
    RenderSettings settings = document().render;
    settings.trace.faults = {};
    naming_.start(picture, world_, document().camera, settings, sessionThreads_);
    report(Notice::Kind::Done,
           fmt::format("{}: tracing the scene with each fault", picture.filename().string()));
}

/// The fault that explains most is compared with, and the first wrong pixel picked.
bool Viewer::updateNaming() {
    try {
        if (!naming_.update()) return naming_.running();
    } catch (const std::exception& error) {
        report(Notice::Kind::Error, error.what());
        return true;
    }
    const auto& [file, width, height, bug] = *naming_.report();
    const FaultSet best = bug.ranked.front().faults;
    if (!bug.firstWrong || best.empty()) {
        report(Notice::Kind::Warning,
               fmt::format("{}: no known fault explains it better than none", file.filename().string()));
        return true;
    }
    report(Notice::Kind::Done, fmt::format("{}: sounds like {}", file.filename().string(), toText(best)));
    execute({"compare", {{"with", "fault=" + toText(best)}}});
    const auto scaled = [](int place, int from, int to) {
        return static_cast<int>(std::int64_t{place} * to / from);
    };
    pick(PixelPosition{scaled(bug.firstWrong->x, width, width_), scaled(bug.firstWrong->y, height, height_)},
         true);
    return true;
}

std::optional<OtherPicture> Viewer::otherPicture() const {
    const Comparison& comparison = document().comparison;
    if (!comparison.on || comparison.isRasterised()) return std::nullopt;
    const Document other = otherSide(document());
    OtherPicture picture{other.camera, other.render, comparison.equal};
    picture.settings.width = width_;
    picture.settings.height = height_;
    picture.settings.display = {}; // how it is displayed changes nothing of the tracing
    return picture;
}

void Viewer::startComparison(const RenderSettings& now, const std::optional<std::string>& switched) {
    if (rasterised_) {
        comparison_.start(rasterised_, now.stop.samples, *session_);
    } else if (compared_) {
        lastSwitch_.clear();
        comparison_.start(world_, compared_->camera, compared_->settings, sessionThreads_,
                          {compared_->equal, now.stop.samples}, *session_);
    } else if (switched) {
        lastSwitch_ = *switched;
        comparison_.start(world_, renderedCamera_, *rendered_, sessionThreads_, {EqualShare::Samples, 1},
                          *session_);
    } else {
        comparison_.stop(*session_);
    }
}

void Viewer::compareWith(std::shared_ptr<const ColorImage> rasterised) {
    if (rasterised == rasterised_) return;
    rasterised_ = std::move(rasterised);
    if (rasterised_)
        comparison_.start(rasterised_, document().render.stop.samples, *session_);
    else if (!compared_)
        comparison_.stop(*session_);
}

bool Viewer::updateComparison() {
    const DisplaySettings display = shownDisplay(document().render);
    const bool measured = comparison_.update(
        *session_, display, compared_ ? shownDisplay(otherSide(document()).render) : display);
    if (measured && !compared_ && !rasterised_) {
        report(Notice::Kind::Done, switchText(lastSwitch_, *comparison_.change()) + "; D shows them");
        comparison_.stop(*session_);
    }
    return measured || comparison_.active();
}

void Viewer::toggleDifference() {
    const Comparison& comparison = document().comparison;
    if (!comparison.on && lastSwitch_.empty())
        throw InputError("difference", "there is nothing to compare with",
                         "switch a kind of rays first, or compare two settings");
    if (comparison.on)
        execute({"compare", {{"difference", toText(!comparison.difference)}}});
    else
        execute({"compare", {{"with", lastSwitch_}, {"difference", "on"}}});
}

bool Viewer::tracing(int samples) const {
    if (naming_.running() || needs_.running()) return true;
    if (paused_) return layers_.active();
    const RenderStatus status = session_->status();
    const int compared = comparison_.change() ? comparison_.change()->samples : 0;
    return (status.active() && status.samples < samples) || layers_.active() || photons_.ends() ||
           (comparison_.active() && (compared < samples || !status.active() || comparison_.measuring()));
}

}
