#include "app/gui/photon_view.h"

#include "core/study/photon_text.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr float kTall = 24; // letters: a picture that more words leave in sight

}

void PhotonView::refresh(const Viewer& viewer) {
    const auto& picture = viewer.photons().picture();
    const DisplaySettings settings = shownDisplay(viewer.document().render);
    if (picture == picture_ && settings == display_) return;
    picture_ = picture;
    display_ = settings;
    ++version_;
    if (picture_) texture_.upload(display(picture_->radiance, settings));
}

void PhotonView::legend(const Widgets& ui, const LegendPlace& place) const {
    const PhotonTally& tally = picture_->tally;
    legendPane(ui, "photon legend", place, [&] {
        ImGui::Text("from the light: %s photons", countText(tally.emitted).c_str());
        ImGui::Text("reached the lens: %s", countText(tally.reached).c_str());
        ImGui::SameLine();
        ImGui::TextDisabled("%s", rarityText(tally.reached, tally.emitted).c_str());
        if (place.height > kTall * ImGui::GetFontSize())
            ImGui::TextWrapped("%s", forecastText(tally, picture_->pixels, picture_->seconds).c_str());
    });
}

}
