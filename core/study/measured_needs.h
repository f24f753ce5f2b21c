#pragma once
// The smallest model of a picture within a tolerance: by proof from its scene, then by tracing some tiles of
// it.

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/study/model_studio.h"

namespace eyeray {

inline constexpr double kDefaultTolerance = 1.0 / 255;

struct NeedsPlan {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    AccelKind accel = AccelKind::Auto;
    RenderSettings settings;    // as set, with the size of the picture that is wanted
    bool meterExposure = false; // from the picture as set, in place of the display's
    /// Share of the displayed range: what is left out changes no pixel by more, as ModelError counts; and
    /// with fewer samples than set the mean ꟻLIP of all together is no more.
    double tolerance = kDefaultTolerance;
    int threads = 0; // 0: one per core
};

/// One thing that the model found has smaller than as set.
struct NeedItem {
    std::string what, from, to; // "max depth", "16", "7"
    std::string reason;         // one line
    bool proved = false;        // no pixel can change; else measured
    double saving = 0;          // share of the time of what was left before it
    ModelError error{};         // of this item alone
    std::string takenBack;      // what the whole picture has shown, if it needs more than those tiles
};

struct MeasuredNeeds {
    std::vector<NeedItem> items;
    PictureModel asSet, needed;
    DisplaySettings display;
    int width = 0, height = 0;          // of the picture
    std::size_t tiles = 0, ofTiles = 0; // of it that were traced to be compared
    int comparedSamples = 0;            // of each pixel
    bool inBlocks = false;              // compared by blocks of kNoiseBlock² pixels
    double tolerance = 0;
    ModelError error; // of all together; ꟻLIP is that of the model, and what samples beyond would change
    double secondsAsSet = 0, secondsNeeded = 0; // of tracing the whole picture

    /// How many times faster.
    double speedUp() const { return secondsNeeded > 0 ? secondsAsSet / secondsNeeded : 1; }

    struct Taken {
        NeedLadder ladder;
        std::size_t rung = 0;
        std::size_t item = 0; // in `items`
    };
    std::vector<Taken> taken; // the measured ones, to be looked at again
};

/// Called as a step of the work begins.
using NeedsStep = std::function<void(const std::string& doing)>;
std::size_t stepsToMeasure();
std::size_t stepsToCheck(const MeasuredNeeds&);

/// Measures pictures of the plan's aspect and at most kNeedsWidth. Each thing is made as small as the
/// tolerance lets it, together with those before. Nothing if `stop` was requested. Throws InputError,
/// Failure.
std::optional<MeasuredNeeds> measureNeeds(const NeedsPlan&, const NeedsStep&, const std::stop_token&);

/// The same looked at again in the whole picture: what fails there is taken back as far as it must, and
/// says so; samples are counted anew. Nothing if `stop` was requested.
std::optional<MeasuredNeeds> checkNeeds(const NeedsPlan&, const MeasuredNeeds&, const NeedsStep&,
                                        const std::stop_token&);

}
