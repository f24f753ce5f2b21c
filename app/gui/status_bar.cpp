#include <fmt/format.h>

#include <algorithm>

#include "app/gui/panels.h"
#include "app/gui/theme.h"

namespace eyeray {
namespace {

using Phase = RenderStatus::Phase;

std::string progress(const RenderStatus& status, const StopSettings& stop, bool building) {
    if (building) return "preparing the scene…";
    switch (status.phase) {
    case Phase::Idle:
        return "idle";
    case Phase::Coarse:
        return "coarse picture…";
    case Phase::Refining:
        return fmt::format("{} of {} samples", status.samples, stop.samples);
    case Phase::Paused:
        return fmt::format("paused at {} samples", status.samples);
    case Phase::Finished:
        return fmt::format("finished: {}", status.finishedBy);
    case Phase::Failed:
        return status.failure;
    }
    return {};
}

}

void statusBar(const Widgets& ui) {
    if (!ui.viewer.hasScene()) {
        ImGui::TextUnformatted(ui.viewer.loading() ? "loading…" : "no scene is open: Ctrl+O opens one");
        return;
    }
    const RenderStatus status = ui.viewer.status();
    const StopSettings& stop = ui.viewer.document().render.stop;
    const auto fraction =
        static_cast<float>((status.samples + status.passProgress * (status.active() ? 1 : 0)) / stop.samples);
    ImGui::ProgressBar(status.phase == Phase::Finished ? 1.0F : std::min(fraction, 1.0F),
                       {ImGui::GetFontSize() * 16, 0}, progress(status, stop, ui.viewer.building()).c_str());
    ui.mark("progress");
    std::string text = fmt::format("{:.1f} s   {:.2f} Mrays/s   depth {}   {} threads", status.seconds,
                                   status.mraysPerSecond(), status.counts.deepest, status.threads);
    const bool uneven = stop.adaptive && status.samples > 0 && status.samplesPerPixel < 0.99 * status.samples;
    if (uneven) text += fmt::format("   {:.1f} samples a pixel", status.samplesPerPixel);
    if (status.estimatedError >= 0) text += fmt::format("   error ±{:.2f}/255", status.estimatedError * 255);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text.c_str());
    if (status.counts.invalidSamples > 0) {
        ImGui::SameLine();
        ImGui::TextColored(errorColor(ui.dark), "  %llu bad samples",
                           static_cast<unsigned long long>(status.counts.invalidSamples));
    }
    if (status.counts.truncatedSamples > 0) {
        ImGui::SameLine();
        ImGui::TextColored(errorColor(ui.dark), "  %llu ray trees cut at %d rays",
                           static_cast<unsigned long long>(status.counts.truncatedSamples), kMaxTreeNodes);
    }
}

void noticesOverlay(const Widgets& ui, float right, float top) {
    const auto& notices = ui.viewer.notices();
    for (std::size_t i = 0; i < notices.size(); ++i) {
        const Notice& notice = notices[i];
        const bool error = notice.kind == Notice::Kind::Error;
        ImGui::SetNextWindowPos({right, top}, ImGuiCond_Always, {1, 0});
        ImGui::SetNextWindowBgAlpha(0.92F);
        ImGui::Begin(fmt::format("notice{}", i).c_str(), nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                         ImGuiWindowFlags_NoSavedSettings);
        ImGui::PushTextWrapPos(std::min(ImGui::GetFontSize() * 34, right - 2 * ImGui::GetFontSize()));
        const ImVec4 color = notice.kind == Notice::Kind::Done ? doneColor(ui.dark) : errorColor(ui.dark);
        ImGui::TextColored(color, "%s", notice.text.c_str());
        ImGui::PopTextWrapPos();
        if (error && ImGui::SmallButton("close")) ui.viewer.dismissNotice(i);
        if (error) ui.mark(fmt::format("close notice {}", i));
        top += ImGui::GetWindowHeight() + ImGui::GetStyle().ItemSpacing.y;
        ImGui::End();
    }
}

}
