#pragma once
// Speed against accuracy: what is to be measured, and what has been.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/scene/world.h"
#include "core/study/picture_errors.h"
#include "core/transport/settings.h"

namespace eyeray {

struct ExperimentSetting {
    TraceSettings trace;
    AccelKind accel = AccelKind::Auto;
    bool adaptive = false; // samples where the noise is, as core/render/adaptive.h says

    friend bool operator==(const ExperimentSetting&, const ExperimentSetting&) = default;
};

/// Every combination of these is measured. None is empty.
struct ExperimentGrid {
    std::vector<Method> methods;
    std::vector<int> depths;
    std::vector<float> cutoffs;
    std::vector<Sampler> samplers;
    std::vector<GlassShadows> glassShadows;
    std::vector<AccelKind> accels;
    std::vector<int> samples; // ascending, each ≥ 1: passes, which adaptive sampling leaves pixels out of
    std::vector<std::uint8_t> shadows = {1}, adaptive = {0}; // off, on
    std::vector<Precision> precisions = {Precision::Float};
};

/// The combinations, each once: depth and cutoff mean nothing to methods without mirrors and glass, the
/// sampler nothing to those without chance, shadows nothing to `local`, precision nothing without a fault.
/// All else is as in `base`.
std::vector<ExperimentSetting> combinations(const ExperimentGrid&, const TraceSettings& base);

/// The method, and what differs in the grid: "whitted d5 bvh2".
std::string labelOf(const ExperimentSetting&, const ExperimentGrid&);

/// What limits a setting's picture when samples are without end: the accelerator, the sampler and where
/// samples go do not.
TraceSettings modelOf(const ExperimentSetting&);

/// The settings that leave nothing out: path tracing to the largest depth. Shadow rays at glass as in `base`.
TraceSettings fullestModel(const TraceSettings& base);

/// A picture taken as right, with the root mean square error that it has itself.
struct Reference {
    ColorImage picture;
    double error = 0;
    int samples = 0;
};

/// Two pictures of half the samples each, with random numbers of their own: what they differ by tells the
/// error of their mean, which is the reference.
using ReferenceHalves = std::array<ColorImage, 2>;
Reference referenceOf(const ReferenceHalves&, int samples);

struct Spread {
    double median = 0, least = 0, most = 0;
};
/// NaN for no values, and for values of which one is.
Spread spreadOf(std::vector<double> values);

struct ExperimentCurve {
    ExperimentSetting setting;
    std::string label;
    Reference limit;         // of its model
    double buildSeconds = 0; // of its index
    ColorImage picture;      // of the most samples
};

enum class ErrorAgainst : std::uint8_t { Limit, Fullest }; // what sampling does; what the model does, too

struct ExperimentPoint {
    struct Repeat {
        double seconds, samplesPerPixel; // spent tracing; on average
        PictureErrors toLimit, toFullest;
    };
    std::size_t curve = 0;
    int samples = 1;
    std::vector<Repeat> repeats; // each with random numbers of its own
    std::string failure;         // why there are none

    Spread seconds() const;
    Spread samplesPerPixel() const;
    Spread error(ErrorAgainst, ErrorMetric) const;
};

struct Experiment {
    DisplaySettings display;
    Reference fullest;
    std::vector<ExperimentCurve> curves;
    std::vector<ExperimentPoint> points; // by curve, then samples
};

/// Slope of the error to a curve's own limit over its samples; nothing if it cannot be told.
std::optional<double> samplingSlope(const Experiment&, std::size_t curve, ErrorMetric);

}
