#include "tests/bench/bench.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/scene_files.h"
#include "core/study/ray_bench.h"

namespace eyeray::bench {
double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void printHeading(const std::string& title, const std::string& unit) {
    fmt::print("\n{}\n{:<34}{:>9}{:>9}{:>9}{:>9}{:>9}{:>6}\n", title, unit, "median", "p95", "min", "max",
               "spread", "n");
}

void printSeries(const std::string& name, std::vector<double> values, const Goal& goal) {
    std::sort(values.begin(), values.end());
    const double median = percentile(values, 0.5), p95 = percentile(values, 0.95);
    fmt::print("{:<34}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>6}", name, median, p95, values.front(),
               values.back(), seriesOf(values).spread, values.size());
    if (goal.of != Goal::Of::None) {
        const bool tail = goal.of == Goal::Of::Percentile95;
        fmt::print("  {} {} <= {:g}",
                   (tail ? p95 : median) <= goal.most ? "met:" : "MISSED:", tail ? "p95" : "median",
                   goal.most);
    }
    fmt::print("\n");
    std::fflush(stdout);
}

Document openForever(const std::string& scene) {
    Document document = openScene(scene).document;
    document.render.width = kWidth;
    document.render.height = kHeight;
    document.render.stop = {.samples = 1'000'000};
    return document;
}

RenderStatus awaitCoarse(RenderSession& session) {
    constexpr auto kPoll = std::chrono::microseconds(200);
    RenderStatus status = session.status();
    while (status.phase == RenderStatus::Phase::Coarse) {
        std::this_thread::sleep_for(kPoll);
        status = session.status();
    }
    return status;
}

}
