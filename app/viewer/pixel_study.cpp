#include "app/viewer/pixel_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/errors.h"

namespace eyeray {
namespace {

constexpr std::size_t kRaysAtATime = 8'000; // retraced for the mean between two frames: a few milliseconds

/// Whether the same node numbers mean the same terms.
bool alike(const Ledger& a, const Ledger& b) {
    return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(),
                      [](const LedgerNode& x, const LedgerNode& y) {
                          return x.term == y.term && x.ray == y.ray && x.lamp == y.lamp && x.end == y.end;
                      });
}

auto placeOf(std::vector<Strike>& strikes, int node) {
    return std::lower_bound(strikes.begin(), strikes.end(), node,
                            [](const Strike& strike, int n) { return strike.node < n; });
}

}

void PixelStudy::look(const PickedSample& picked, const Scene& scene) {
    Ledger ledger = ledgerOf(picked.trace);
    if (picked.pixel != pixel_ || picked.sample != sample_ || !alike(ledger, ledger_)) {
        strikes_.clear();
        settings_.filter.collapsed.clear();
    }
    pixel_ = picked.pixel;
    sample_ = picked.sample;
    ledger_ = std::move(ledger);
    family_ = Family(picked.trace);
    diagram_ = diagramOf(picked.trace, scene, settings_.filter);
}

void PixelStudy::strike(int node, bool out) {
    if (node < 0 || node >= static_cast<int>(ledger_.nodes.size()))
        throw InputError(fmt::format("strike term={}", node), "the picked pixel's sum has no such term",
                         fmt::format("pick a pixel; its terms are 0 to {}", ledger_.nodes.size() - 1));
    const auto place = placeOf(strikes_, node);
    const bool struck = place != strikes_.end() && place->node == node;
    if (out && !struck) strikes_.insert(place, strikeOf(ledger_, node));
    if (!out && struck) strikes_.erase(place);
}

bool PixelStudy::isStruck(int node) const {
    return std::any_of(strikes_.begin(), strikes_.end(),
                       [&](const Strike& strike) { return strike.node == node; });
}

bool PixelStudy::average(const RenderSession& session, const PixelPosition& pixel) {
    const auto now = session.pixel(pixel.x, pixel.y);
    if (!now) return false;
    if (now->film != film_.film || pixel != averaged_) mean_ = {};
    const bool fresh = now->film != film_.film || pixel != averaged_ || now->samples != film_.samples;
    film_ = *now;
    averaged_ = pixel;
    const int before = mean_.samples();
    for (std::size_t rays = 0; mean_.samples() < film_.samples && rays < kRaysAtATime;) {
        const auto trace = session.retrace(pixel.x, pixel.y, mean_.samples());
        if (!trace) break;
        mean_.add(trace->radiance);
        rays += std::max<std::size_t>(trace->rays.size(), 1);
    }
    // another picture may have come between
    const auto after = session.pixel(pixel.x, pixel.y);
    if (!after || after->film != film_.film) mean_ = {};
    return fresh || mean_.samples() != before;
}

}
