#pragma once
// Pictures of models, of one size, made to be compared.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/render/render_settings.h"
#include "core/study/pass_loop.h"
#include "core/study/picture_model.h"

namespace eyeray {

/// How far a picture is from another: the largest difference of a displayed channel, in steps of 1/255, of
/// any pixel (of methods that scatter: of any block of kNoiseBlock² pixels), and mean ꟻLIP.
struct ModelError {
    int steps = 0;
    double flip = 0;
};

inline constexpr int kNoiseBlock = 8;         // pixels
inline constexpr int kStudioTiles = 10;       // in a row
inline constexpr int kModelSamples = 4;       // of each pixel, to compare models by
inline constexpr int kNoisyModelSamples = 16; // of methods that scatter

/// A model's picture of a few samples.
struct ModelShot {
    ColorImage picture;
    std::uint64_t rays = 0;
    double secondsPerSample = 0; // of each pixel of the whole picture, on all threads; of the fastest
};

/// How many samples are enough, and how many there would be: at most, and of a pixel on average.
struct EnoughSamples {
    int enough = 1, asSet = 1;
    double meanEnough = 1, meanAsSet = 1;
    double flip = 0; // what the samples after those that are enough would still change
};

/// Thrown by all of ModelStudio's functions once its stop was requested.
struct StudioClosed {};

class ModelStudio {
public:
    /// `settings` give the size, the seed and the display; `part`: trace and compare no more than
    /// kStudioTiles across of the picture's tiles; `blocks`: compare blocks in place of pixels.
    ModelStudio(const RenderSettings& settings, bool part, bool blocks, int threads, std::stop_token);

    std::size_t tiles() const { return mosaic_.tiles.size(); }
    int comparedSamples() const { return blocks_ ? kNoisyModelSamples : kModelSamples; }
    void meterBy(const ModelShot&);
    const DisplaySettings& display() const { return settings_.display; }

    /// `force` changes what the renderer takes for needed.
    ModelShot shoot(const PictureModel&, const std::function<void(SceneNeeds&)>& force = {});

    ModelError compare(const ModelShot& reference, const ModelShot& test) const;

    /// The fewest samples, a power of two, to which as many again change no more than mean ꟻLIP `tolerance`;
    /// else as set. Of independent samples the truth is √2 times as far away as the mean with as many again;
    /// of well spread ones it is nearer. Looks from `least` on.
    EnoughSamples enoughSamples(const PictureModel&, double tolerance, int least);

    std::shared_ptr<const World> world(const PictureModel&);

private:
    void endByError(EnoughSamples&, const PassLoop&) const;
    PassLoop loop(const PictureModel&, std::shared_ptr<const World>);
    ByteImage shown(const ColorImage&) const;
    void look() const;

    RenderSettings settings_;
    bool blocks_;
    Mosaic mosaic_;
    double share_; // of the picture's pixels that are in it
    ThreadPool pool_;
    std::stop_token stop_;
    std::vector<std::shared_ptr<const World>> worlds_; // the last ones
};

}
