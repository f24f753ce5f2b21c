#pragma once
// The measuring itself.

#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/render/render_settings.h"
#include "core/study/experiment.h"

namespace eyeray {

struct ExperimentPlan {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    int width = 320, height = 180; // pixels
    std::uint32_t seed = 0;
    DisplaySettings display;
    bool meterExposure = false; // from the fullest model's picture, in place of display's
    ExperimentGrid grid;
    TraceSettings base;
    int repeats = 3;
    int referenceSamples = 0;               // even
    double adaptiveError = kInvisibleError; // that adaptive sampling aims at, of displayed values
    double limitSeconds = 30; // of tracing, for each curve and repeat: what takes longer has failed
    int threads = 0;          // 0: one per core
};

/// Where pictures taken as right are kept from one experiment to the next.
struct ReferenceStore {
    std::function<std::optional<ReferenceHalves>(const TraceSettings&)> find;
    std::function<void(const TraceSettings&, const ReferenceHalves&)> keep;
};

/// Read by one thread while another measures.
class ExperimentProgress {
public:
    struct State {
        std::string doing;
        double done = 0, expected = 0; // seconds of tracing, as foreseen
    };
    void expect(double seconds);
    void begin(std::string what);
    void did(double seconds);
    State state() const;

private:
    mutable std::mutex mutex_;
    State state_;
};

/// Measures on the calling thread and those of a pool. A point that fails says why and the others go on; a
/// stop leaves points that say so. Nothing if stopped before the references are there. Throws InputError,
/// Failure where the scene itself or the fullest model cannot be rendered.
std::optional<Experiment> runExperiment(const ExperimentPlan&, const ReferenceStore&, ExperimentProgress&,
                                        const std::stop_token&);

}
