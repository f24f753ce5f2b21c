#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/interruption.h"
#include "app/cli/progress.h"
#include "app/cli/run.h"
#include "core/image/atomic_file.h"
#include "core/study/stability_report.h"

namespace eyeray {
namespace {

/// Asks to stop when the program was asked to end.
std::jthread stopWhenInterrupted(std::stop_source& work) {
    static constexpr auto kInterval = std::chrono::milliseconds(50);
    return std::jthread([&work](const std::stop_token& end) {
        while (!end.stop_requested() && !interrupted()) std::this_thread::sleep_for(kInterval);
        if (interrupted()) work.request_stop();
    });
}

std::vector<StabilityResult> measureAll(const StabilityOptions& options) {
    std::stop_source work;
    const std::jthread watch = stopWhenInterrupted(work);
    const std::vector<StabilityCase>& cases = stabilityCases();
    Progress progress(cases.size());
    std::vector<StabilityResult> results;
    for (const StabilityCase& subject : cases) {
        results.push_back(measureCase(subject, {.trials = options.rays, .stop = work.get_token()}));
        if (work.stop_requested()) break;
        progress.step(fmt::format("{} {}", subject.id, subject.title));
    }
    return results;
}

nlohmann::ordered_json jsonOf(const StabilityPoint& point) {
    nlohmann::ordered_json json{{"value", point.parameter}};
    for (const Form form : kForms) {
        const auto index = static_cast<std::size_t>(form);
        const auto& measured = point.forms[index];
        if (!measured) continue;
        json[std::string(kFormNames[index])] = {{"error", measured->error},
                                                {"failures_per_million", measured->failuresPerMillion},
                                                {"nanoseconds", measured->nanoseconds}};
    }
    return json;
}

nlohmann::ordered_json jsonOf(const StabilityResult& result) {
    const StabilityCase& subject = *result.subject;
    nlohmann::ordered_json json{
        {"case", subject.id},
        {"title", subject.title},
        {"why", subject.why},
        {"fix", subject.fix},
        {"parameter", subject.parameter},
        {"error_is", subject.error},
        {"failure_is", subject.failure},
        {"mark", {{"error", subject.mark.error}, {"failures_per_million", subject.mark.failuresPerMillion}}},
        {"passes", result.passes()},
        {"points", nlohmann::ordered_json::array()}};
    for (const auto& [key, form] :
         {std::pair{"times_naive_float", Form::NaiveFloat}, {"times_naive_double", Form::NaiveDouble}})
        if (const auto cost = result.cost(form)) json[key] = *cost;
    for (const StabilityPoint& point : result.points) json["points"].push_back(jsonOf(point));
    return json;
}

void write(const std::filesystem::path& file, const std::string& text) {
    writeFileAtomically(file, std::as_bytes(std::span(text)));
}

}

int run(const StabilityOptions& options) {
    makeFolder(options.folder);
    heedInterrupts();
    const std::vector<StabilityResult> results = measureAll(options);
    if (interrupted()) {
        fmt::print(stderr, "eyeray: interrupted: nothing is written\n");
        return 1;
    }
    write(options.folder / "cases.csv", stabilityCsv(results));
    write(options.folder / "report.html",
          stabilityPage(results,
                        fmt::format("{} rays of each form at each value, on one thread.", options.rays)));
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const StabilityResult& result : results) json.push_back(jsonOf(result));
    printWhole(options.json ? json.dump(2) + "\n" : stabilityText(results));
    const auto missed = std::ranges::count_if(results, [](const auto& result) { return !result.passes(); });
    if (missed > 0)
        fmt::print(stderr, "eyeray: {} of {} robust forms miss their marks\n", missed, results.size());
    return missed > 0 ? 1 : 0;
}

}
