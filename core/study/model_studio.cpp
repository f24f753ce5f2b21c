#include "core/study/model_studio.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/image/flip.h"
#include "core/image/metrics.h"
#include "core/render/adaptive.h"
#include "core/scene/choose_index.h"

namespace eyeray {
namespace {

constexpr double kNoLimit = 1e12;      // seconds
constexpr std::size_t kKeptWorlds = 3; // as set, as found so far, as tried

/// Means over squares of so many pixels; those at the border may be smaller.
ColorImage blockMeans(const ColorImage& picture, int side) {
    ColorImage means((picture.width() + side - 1) / side, (picture.height() + side - 1) / side);
    for (int by = 0; by < means.height(); ++by)
        for (int bx = 0; bx < means.width(); ++bx) {
            Color sum(0);
            int pixels = 0;
            for (int y = by * side; y < std::min((by + 1) * side, picture.height()); ++y)
                for (int x = bx * side; x < std::min((bx + 1) * side, picture.width()); ++x, ++pixels)
                    sum += picture.at(x, y);
            means.at(bx, by) = sum / static_cast<float>(pixels);
        }
    return means;
}

/// A picture as far from that of n samples as the truth is by their standard error, on the way to that of 2n.
ColorImage likelyTruth(const ColorImage& once, const ColorImage& twice) {
    constexpr auto kFarther = std::numbers::sqrt2_v<float>;
    ColorImage truth(once.width(), once.height());
    for (std::size_t i = 0; i < truth.values().size(); ++i)
        truth.values()[i] = glm::max(glm::mix(once.values()[i], twice.values()[i], kFarther), Color(0));
    return truth;
}

}

AccelKind indexOf(const PictureModel& model) {
    return chooseIndex(*model.scene, {model.accel, isByStreams(model.trace.method)});
}

ModelStudio::ModelStudio(const RenderSettings& settings, bool part, bool blocks, int threads,
                         std::stop_token stop)
    : settings_(settings), blocks_(blocks),
      mosaic_(mosaicOf(settings.width, settings.height, part ? kStudioTiles : settings.width)),
      share_(static_cast<double>(mosaic_.width) * mosaic_.height /
             (static_cast<double>(settings.width) * settings.height)),
      pool_(threads), stop_(std::move(stop)) {}

PassLoop ModelStudio::loop(const PictureModel& model, std::shared_ptr<const World> traced) {
    const TraceContext context(std::move(traced), model.camera, model.trace, settings_.width,
                               settings_.height, settings_.seed, {});
    return {makeIntegrator(model.trace.method), context, pool_, mosaic_};
}

void ModelStudio::look() const {
    if (stop_.stop_requested()) throw StudioClosed();
}

void ModelStudio::meterBy(const ModelShot& shot) {
    settings_.display.exposure = std::clamp(meteredExposure(shot.picture), -20.0, 20.0);
}

ByteImage ModelStudio::shown(const ColorImage& picture) const {
    return eyeray::display(picture, shownDisplay(settings_));
}

std::shared_ptr<const World> ModelStudio::world(const PictureModel& model) {
    const AccelKind index = indexOf(model);
    for (const auto& world : worlds_)
        if (world->accelKind == index && world->scene == model.scene) return world;
    const World* const previous = worlds_.empty() ? nullptr : worlds_.back().get();
    auto built = buildWorld(model.scene, {index}, previous, stop_);
    look();
    if (worlds_.size() >= kKeptWorlds) worlds_.erase(worlds_.begin() + 1);
    worlds_.push_back(built);
    return built;
}

ModelShot ModelStudio::shoot(const PictureModel& model, const std::function<void(SceneNeeds&)>& force) {
    std::shared_ptr<const World> traced = world(model);
    if (force) {
        World forced = *traced;
        force(forced.needs);
        traced = std::make_shared<const World>(std::move(forced));
    }
    PassLoop passes = loop(model, traced);
    double least = kNoLimit;
    for (int i = 0; i < std::min(comparedSamples(), model.samples); ++i) {
        const double before = passes.threadSeconds();
        if (!passes.pass(kNoLimit, stop_)) throw StudioClosed();
        least = std::min(least, passes.threadSeconds() - before);
    }
    ModelShot shot{.picture = passes.picture(),
                   .rays = passes.counts().total(),
                   .secondsPerSample = least / (share_ * pool_.threads())};
    return shot;
}

ModelError ModelStudio::compare(const ModelShot& reference, const ModelShot& test) const {
    look();
    const ByteImage a = shown(reference.picture), b = shown(test.picture);
    const int steps = blocks_ ? maxByteDifference(shown(blockMeans(reference.picture, kNoiseBlock)),
                                                  shown(blockMeans(test.picture, kNoiseBlock)))
                              : maxByteDifference(a, b);
    return {steps, countDifferingPixels(a, b) > 0 ? meanFlip(flip(a, b)) : 0};
}

EnoughSamples ModelStudio::enoughSamples(const PictureModel& model, double tolerance, int least) {
    PassLoop passes = loop(model, world(model));
    const auto traceTo = [&](int count) {
        while (passes.passes() < count)
            if (!passes.pass(kNoLimit, stop_)) throw StudioClosed();
        return passes.picture();
    };
    EnoughSamples result{.enough = model.samples, .asSet = model.samples};
    ColorImage once = traceTo(least);
    for (int n = least; 2 * n <= model.samples; n *= 2) {
        ColorImage twice = traceTo(2 * n);
        const double change = meanFlip(flip(shown(once), shown(likelyTruth(once, twice))));
        look();
        if (change <= tolerance) {
            result.enough = n;
            result.flip = change;
            break;
        }
        // ꟻLIP falls no faster than as 1/n: beyond hope, all are needed
        if (n >= 4 && change * 2 * n > tolerance * model.samples) break;
        once = std::move(twice);
    }
    if (settings_.stop.error > 0 && model.samples > 1) {
        traceTo(std::max(passes.passes(), std::min(kAdaptivePilot, model.samples)));
        endByError(result, passes);
    } else {
        result.meanAsSet = result.asSet;
        result.meanEnough = result.enough;
    }
    return result;
}

/// When the picture, or each of its pixels, would end by the error that is asked for: the standard error
/// falls as 1/√n.
void ModelStudio::endByError(EnoughSamples& samples, const PassLoop& passes) const {
    const double wanted = settings_.stop.error;
    std::vector<int> likely = passes.likelySamples(wanted, settings_.display, samples.asSet);
    if (!settings_.stop.adaptive) {
        const double ratio = passes.estimatedError(settings_.display) / wanted;
        const double stopped = std::ceil(passes.passes() * ratio * ratio);
        const int pilot = std::min(kErrorPilot, samples.asSet);
        likely.assign(1, static_cast<int>(std::clamp<double>(stopped, pilot, samples.asSet)));
    }
    samples.asSet = std::ranges::max(likely);
    samples.enough = std::min(samples.enough, samples.asSet);
    const auto meanUpTo = [&](int most) {
        const auto add = [&](double sum, int n) { return sum + std::min(n, most); };
        return std::accumulate(likely.begin(), likely.end(), 0.0, add) / static_cast<double>(likely.size());
    };
    samples.meanAsSet = meanUpTo(samples.asSet);
    samples.meanEnough = meanUpTo(samples.enough);
}

}
