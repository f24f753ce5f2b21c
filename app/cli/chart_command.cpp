#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <future>

#include "app/cli/chart.h"
#include "app/cli/chart_lists.h"
#include "app/cli/interruption.h"
#include "app/cli/run.h"
#include "core/base/errors.h"
#include "core/base/thread_pool.h"
#include "core/image/atomic_file.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kWidth = 320;          // pixels, where no option says
constexpr int kReferenceByMost = 16; // samples of references, in those of the finest point
constexpr auto kInterval = std::chrono::milliseconds(100);

ExperimentPlan planFrom(const OpenedScene& opened, const ChartOptions& options) {
    const Document& document = opened.document;
    ExperimentPlan plan;
    plan.scene = document.scene;
    plan.camera = document.camera;
    plan.grid = gridFrom(options.lists, document.render.trace);
    plan.base = document.render.trace;
    plan.display = document.render.display;
    plan.meterExposure = opened.meterExposure;
    plan.seed = document.render.seed;
    plan.threads = document.threads;
    plan.repeats = options.repeats;
    plan.limitSeconds = options.limitSeconds;
    plan.adaptiveError = options.adaptiveError;
    plan.referenceSamples =
        options.referenceSamples > 0 ? options.referenceSamples : kReferenceByMost * plan.grid.samples.back();
    plan.referenceSamples += plan.referenceSamples % 2; // two halves
    PictureOptions size = options.picture;
    if (!size.width && !size.height) size.width = kWidth;
    RenderSettings sized;
    setSize(sized, size, document.aspect);
    plan.width = sized.width;
    plan.height = sized.height;
    return plan;
}

void checkTarget(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw Failure(folder.string(), "is no folder", "give the name of a folder");
    checkFolder(folder);
}

class ProgressLine {
public:
    explicit ProgressLine(bool shown) : shown_(shown) {}
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() {
        if (shown_) fmt::print(stderr, "\r\033[K");
    }
    void show(const ExperimentProgress::State& state) const {
        if (!shown_) return;
        const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
        const double left = state.done > 0 ? elapsed / state.done * (state.expected - state.done) : 0;
        const double percent = state.expected > 0 ? 100 * state.done / state.expected : 0;
        fmt::print(stderr, "\r{}: {:.0f} %, {:.0f} s left\033[K", state.doing, percent, std::max(0.0, left));
        std::fflush(stderr);
    }

private:
    const bool shown_;
    const Clock::time_point start_ = Clock::now();
};

/// Measures on a thread of its own, so that this one can heed an interruption at once.
std::optional<Experiment> measure(const ExperimentPlan& plan, const ReferenceStore& store, bool shown) {
    ExperimentProgress progress;
    std::stop_source stop;
    auto experiment = std::async(std::launch::async,
                                 [&] { return runExperiment(plan, store, progress, stop.get_token()); });
    const ProgressLine line(shown);
    while (experiment.wait_for(kInterval) != std::future_status::ready) {
        if (interrupted()) stop.request_stop();
        line.show(progress.state());
    }
    return experiment.get();
}

void write(const fs::path& file, const std::string& text) {
    writeFileAtomically(file, std::as_bytes(std::span(text)));
}

}

int run(const ChartOptions& options) {
    checkTarget(options.output);
    const OpenedScene opened = openFor(options.picture);
    Chart chart{opened.reference, planFrom(opened, options), {}, {}, 1};
    chart.metric = static_cast<ErrorMetric>(std::ranges::find(kErrorMetricNames, options.metric) -
                                            kErrorMetricNames.begin());
    chart.threads = ThreadPool(chart.plan.threads).threads();
    heedInterrupts();
    auto experiment =
        measure(chart.plan, referenceStore(opened, chart.plan), !options.quiet && isatty(STDERR_FILENO) != 0);
    if (!experiment) {
        fmt::print(stderr, "eyeray: interrupted before there was anything to compare with: nothing is "
                           "written\n");
        return 1;
    }
    chart.experiment = std::move(*experiment);
    fs::create_directory(options.output);
    write(options.output / "points.csv", csvOf(chart));
    write(options.output / "chart.svg", svgOf(plotsOf(chart), {}));
    write(options.output / "report.html", reportOf(chart));
    fmt::print("{}", textOf(chart));
    if (interrupted()) fmt::print(stderr, "eyeray: interrupted: points not measured are marked so\n");
    return 0;
}

}
