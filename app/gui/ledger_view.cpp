#include <fmt/format.h>

#include "app/gui/panels.h"

namespace eyeray {

void ledgerView(const Widgets& ui) {
    const auto& picked = ui.viewer.picked();
    if (!picked) return dimmedText("click the picture to see what a pixel's colour is the sum of");
    const Color& c = picked->trace.radiance;
    ImGui::TextUnformatted(
        fmt::format("sample {} = {:.4f} {:.4f} {:.4f}", picked->sample, c.r, c.g, c.b).c_str());
}

}
