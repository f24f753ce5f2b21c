#include "app/rayview/photon_arrows.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr float kFaintest = 0.2F;

}

std::vector<Arrow> arrowsOf(std::span<const PhotonPath> paths, float reach) {
    std::vector<Arrow> arrows;
    for (const PhotonPath& path : paths) {
        for (const PhotonStep& step : path.steps) {
            const bool last = &step == &path.steps.back();
            const bool escapes = last && path.end == PhotonEnd::Escaped;
            const float share = maxComponent(step.power) / maxComponent(path.emitted.power);
            Arrow arrow{.sample = -1, // of no picked sample
                        .ray = static_cast<int>(arrows.size()),
                        .kind = step.kind,
                        .end = escapes ? RayEnd::Background : RayEnd::Hit,
                        .endless = escapes,
                        .from = step.from,
                        .to = step.to,
                        .weight = 0.5F * share,
                        .opacity = std::clamp(share, kFaintest, 1.0F)};
            if (escapes) arrow.to = step.from + reach * glm::normalize(step.to - step.from);
            if (path.end == PhotonEnd::Lens) arrow.weight = arrow.opacity = 1; // the few that count
            arrows.push_back(arrow);
        }
    }
    return arrows;
}

}
