#include <fmt/format.h>

#include "core/study/stability_report.h"

namespace eyeray {
namespace {

std::string cellOf(const std::optional<Measured>& measured, double Measured::* figure, const char* format) {
    return measured ? fmt::format(fmt::runtime(format), (*measured).*figure) : "-";
}

std::string timesOf(const std::optional<double>& cost) { return cost ? fmt::format("{:.2f}", *cost) : "-"; }

/// A cell for each form.
std::string cellsOf(const StabilityResult& result, double Measured::* figure, const char* format, int width) {
    std::string cells;
    for (const Form form : kForms)
        cells += fmt::format("{:>{}}", cellOf(result.worst(form), figure, format), width);
    return cells;
}

}

std::string stabilityText(std::span<const StabilityResult> results) {
    std::string text = fmt::format("{:50}{:^30}{:^27}{:^21}{:^16}\n{:50}", "", "largest error",
                                   "failures a million", "ns at most", "robust / naive", "");
    for (const int width : {10, 9, 7})
        for (const char* form : {"float", "double", "robust"}) text += fmt::format("{:>{}}", form, width);
    text += fmt::format("{:>8}{:>8}\n", "float", "double");
    for (const StabilityResult& result : results)
        text += fmt::format("{:<5}{:<45}{}{}{}{:>8}{:>8}{}\n", result.subject->id, result.subject->title,
                            cellsOf(result, &Measured::error, "{:.2g}", 10),
                            cellsOf(result, &Measured::failuresPerMillion, "{:.0f}", 9),
                            cellsOf(result, &Measured::nanoseconds, "{:.0f}", 7),
                            timesOf(result.cost(Form::NaiveFloat)), timesOf(result.cost(Form::NaiveDouble)),
                            result.passes() ? "" : "  misses its mark");
    return text;
}

std::string stabilityCsv(std::span<const StabilityResult> results) {
    std::string csv = "case,title,parameter,value,form,error_is,error,failures_per_million,nanoseconds,"
                      "times_naive_float,mark_error,mark_failures_per_million\n";
    for (const StabilityResult& result : results)
        for (const StabilityPoint& point : result.points)
            for (const Form form : kForms) {
                const auto& measured = point.forms[static_cast<std::size_t>(form)];
                if (!measured) continue;
                const auto& taught = point.forms[static_cast<std::size_t>(Form::NaiveFloat)];
                const bool timed = taught && taught->nanoseconds > 0 && measured->nanoseconds > 0;
                csv += fmt::format(
                    "{},\"{}\",\"{}\",{:.6g},{},\"{}\",{:.6g},{:.6g},{:.4g},{},{:.6g},{:.6g}\n",
                    result.subject->id, result.subject->title, result.subject->parameter, point.parameter,
                    kFormNames[static_cast<std::size_t>(form)], result.subject->error, measured->error,
                    measured->failuresPerMillion, measured->nanoseconds,
                    timed ? fmt::format("{:.3g}", measured->nanoseconds / taught->nanoseconds) : "",
                    result.subject->mark.error, result.subject->mark.failuresPerMillion);
            }
    return csv;
}

}
