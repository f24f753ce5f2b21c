#include "app/document/document_needs.h"

#include <fmt/format.h>

#include <cmath>

namespace eyeray {

NeedsPlan needsPlan(const Document& document, int width, int height, bool meterExposure) {
    NeedsPlan plan;
    plan.scene = document.scene;
    plan.camera = document.camera;
    plan.accel = document.accel;
    plan.settings = document.render;
    plan.settings.width = width;
    plan.settings.height = height;
    plan.meterExposure = meterExposure;
    plan.threads = document.threads;
    return plan;
}

Document withNeeded(const Document& document, const MeasuredNeeds& needs) {
    Document smaller = document;
    smaller.scene = needs.needed.scene;
    smaller.camera = needs.needed.camera;
    smaller.render.trace = needs.needed.trace;
    smaller.render.stop.samples = needs.needed.samples;
    smaller.accel = needs.needed.accel;
    return smaller;
}

std::string changeText(const NeedItem& item) {
    if (item.from == item.to) return "stays " + item.from;
    if (item.to == "left out") return item.to;
    return fmt::format("{} to {}", item.from, item.to);
}

std::string savingText(const NeedItem& item) {
    const double percent = std::floor(100 * item.saving + 0.5);
    return percent < 1 ? "under 1 %" : fmt::format("{:.0f} %", percent);
}

std::string errorText(const ModelError& error) {
    if (error.steps == 0 && error.flip == 0) return "none";
    if (error.steps == 0) return fmt::format("FLIP {:.4f}", error.flip);
    return fmt::format("{}/255, FLIP {:.4f}", error.steps, error.flip);
}

std::string summaryText(const MeasuredNeeds& needs) {
    if (needs.items.empty()) return "the picture needs all that is set";
    return fmt::format("{:.1f} times faster: {:.2g} s in place of {:.2g} s; error {}", needs.speedUp(),
                       needs.secondsNeeded, needs.secondsAsSet, errorText(needs.error));
}

std::string_view indexName(const MeasuredNeeds& needs) {
    return kAccelNames[static_cast<std::size_t>(indexOf(needs.asSet))];
}

std::string measureText(const MeasuredNeeds& needs) {
    const std::string where = needs.tiles == needs.ofTiles
                                  ? fmt::format("in all of {}x{}", needs.width, needs.height)
                                  : fmt::format("in {} of {} tiles of {}x{}", needs.tiles, needs.ofTiles,
                                                needs.width, needs.height);
    const std::string part =
        needs.inBlocks ? fmt::format("block of {0}x{0} pixels", kNoiseBlock) : std::string("pixel");
    return fmt::format(
        "measured {} with {} samples, index {}: no {} may change by more than {:.3g}/255; mean FLIP is "
        "at most {:.4f}",
        where, needs.comparedSamples, indexName(needs), part, std::floor(255 * needs.tolerance + 1e-9),
        needs.tolerance);
}

}
