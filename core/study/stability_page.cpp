#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/study/plot.h"
#include "core/study/report_page.h"
#include "core/study/stability_report.h"

namespace eyeray {
namespace {

constexpr std::array kMarks = {PlotMark::Disc, PlotMark::Square, PlotMark::Diamond}; // by Form
constexpr int kMarkColor = 3;

/// Of a case of yes or no the error is the share of failures.
bool showsFailures(const StabilityCase& subject) { return subject.showsFailures || subject.mark.error == 0; }

constexpr const char* kFailures = "failures a million";
constexpr Axis kFailureAxis{Scale::Log, 0.5, 2e6};

double shown(const StabilityCase& subject, const Measured& measured) {
    return showsFailures(subject) ? measured.failuresPerMillion : measured.error;
}

std::string figuresOf(const StabilityCase& subject, const Measured& measured) {
    std::string text = fmt::format("{}: {}\nfailures: {} a million", subject.error,
                                   shortNumber(measured.error), shortNumber(measured.failuresPerMillion));
    if (measured.nanoseconds > 0) text += fmt::format("\n{} ns", shortNumber(measured.nanoseconds));
    return text;
}

PlotSeries seriesOf(const StabilityResult& result, Form form) {
    const auto index = static_cast<std::size_t>(form);
    PlotSeries series{.name = std::string(kFormNames[index]),
                      .color = static_cast<int>(index),
                      .mark = kMarks[index],
                      .points = {}};
    for (const StabilityPoint& point : result.points)
        if (const auto& measured = point.forms[index])
            series.points.push_back(
                {.x = point.parameter,
                 .y = shown(*result.subject, *measured),
                 .hover = fmt::format("{}, {}: {}\n{}", kFormNames[index], result.subject->parameter,
                                      shortNumber(point.parameter), figuresOf(*result.subject, *measured))});
    return series;
}

std::string chartOf(const StabilityResult& result) {
    const StabilityCase& subject = *result.subject;
    Plot plot;
    plot.xTitle = subject.parameter;
    plot.yTitle = showsFailures(subject) ? kFailures : subject.error;
    for (const Form form : kForms)
        if (PlotSeries series = seriesOf(result, form); !series.points.empty())
            plot.series.push_back(std::move(series));
    if (!showsFailures(subject) && !result.points.empty())
        plot.series.push_back({.name = "mark",
                               .color = kMarkColor,
                               .mark = PlotMark::None,
                               .line = PlotLine::Dashed,
                               .points = {{.x = result.points.front().parameter, .y = subject.mark.error},
                                          {.x = result.points.back().parameter, .y = subject.mark.error}}});
    fitAxes(plot, subject.logarithmic ? Scale::Log : Scale::Linear, Scale::Log);
    if (showsFailures(subject)) plot.y = kFailureAxis;
    return svgOf(plot, {.width = 560, .height = 340, .letter = 12});
}

std::string timesOf(const std::optional<double>& cost) { return cost ? shortNumber(*cost, 2) : "-"; }

std::string captionOf(const StabilityResult& result) {
    const StabilityCase& subject = *result.subject;
    std::string text = fmt::format("What fails: {}. What helps: {}. Counted as failures: {}.", subject.why,
                                   subject.fix, subject.failure);
    if (const auto cost = result.cost(Form::NaiveFloat))
        text +=
            fmt::format(" Takes {} times as long as the naive form in float{}.", timesOf(cost),
                        result.cost(Form::NaiveDouble) ? fmt::format(", {} times as long as in double",
                                                                     timesOf(result.cost(Form::NaiveDouble)))
                                                       : "");
    return text;
}

/// Median time and mean failures over the sweep.
PlotPoint overall(const StabilityResult& result, Form form) {
    const auto index = static_cast<std::size_t>(form);
    std::vector<double> times;
    double failures = 0;
    for (const StabilityPoint& point : result.points) {
        const auto& measured = point.forms[index];
        if (!measured || !(measured->nanoseconds > 0)) continue;
        times.push_back(measured->nanoseconds);
        failures += measured->failuresPerMillion;
    }
    if (times.empty()) return {.x = NAN};
    failures /= static_cast<double>(times.size());
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, middle);
    return {.x = *middle,
            .y = failures,
            .label = form == Form::NaiveFloat ? std::string(result.subject->id) : "",
            .hover = fmt::format("{} {}, {}\n{} failures a million\n{} ns", result.subject->id,
                                 result.subject->title, kFormNames[index], shortNumber(failures),
                                 shortNumber(*middle))};
}

std::string timeAgainstError(std::span<const StabilityResult> results) {
    Plot plot;
    plot.xTitle = "time of a ray, ns (median over the sweep)";
    plot.yTitle = "failures a million (mean over the sweep)";
    for (const Form form : kForms) {
        const auto index = static_cast<std::size_t>(form);
        PlotSeries series{.name = std::string(kFormNames[index]),
                          .color = static_cast<int>(index),
                          .mark = kMarks[index],
                          .line = PlotLine::None,
                          .points = {}};
        for (const StabilityResult& result : results)
            if (PlotPoint point = overall(result, form); !std::isnan(point.x))
                series.points.push_back(std::move(point));
        plot.series.push_back(std::move(series));
    }
    fitAxes(plot, Scale::Log, Scale::Log);
    plot.y = kFailureAxis;
    return svgOf(plot);
}

std::string costOfTheCure(std::span<const StabilityResult> results) {
    Plot plot;
    plot.xTitle = "time of the robust form / time of the naive one in float";
    plot.yTitle = "failures a million of the naive form (mean)";
    PlotSeries series{.name = {}, .line = PlotLine::None, .points = {}};
    for (const StabilityResult& result : results) {
        const auto cost = result.cost(Form::NaiveFloat);
        if (!cost) continue;
        PlotPoint point = overall(result, Form::NaiveFloat);
        point.x = *cost;
        point.hover += fmt::format("\nrobust form: {} times as long", shortNumber(*cost, 2));
        series.points.push_back(std::move(point));
    }
    plot.series.push_back(std::move(series));
    fitAxes(plot, Scale::Log, Scale::Log);
    return svgOf(plot);
}

ReportTable tableOf(std::span<const StabilityResult> results) {
    ReportTable table;
    table.head = {"",
                  "What goes wrong",
                  "Largest error: naive float",
                  "naive double",
                  "robust",
                  "Failures a million: naive float",
                  "naive double",
                  "robust",
                  "ns: naive float",
                  "naive double",
                  "robust",
                  "Robust / naive float",
                  "Keeps to its mark"};
    for (const StabilityResult& result : results) {
        std::vector<std::string> cells = {std::string(result.subject->id),
                                          std::string(result.subject->title)};
        for (const auto figure : {&Measured::error, &Measured::failuresPerMillion, &Measured::nanoseconds})
            for (const Form form : kForms) {
                const auto worst = result.worst(form);
                cells.push_back(worst ? shortNumber((*worst).*figure, 2) : "-");
            }
        cells.push_back(timesOf(result.cost(Form::NaiveFloat)));
        cells.emplace_back(result.passes() ? "yes" : "no");
        table.rows.push_back({std::move(cells), !result.passes()});
    }
    return table;
}

}

std::string stabilityPage(std::span<const StabilityResult> results, std::string_view circumstances) {
    const auto passing = std::ranges::count_if(results, &StabilityResult::passes);
    ReportPage page(
        "Where ray tracing fails, and what it costs not to",
        fmt::format("{} known failures. Each formula as it is taught, in float and in double, beside "
                    "the renderer's own: {} of {} of these keep to their marks. {}",
                    results.size(), passing, results.size(), circumstances));
    page.section("Time against error");
    page.figure(
        timeAgainstError(results),
        "Each mark is one form of one failure; hollow ones at the lower edge never fail. Numbers stand "
        "at the naive forms in float; names and figures appear under the pointer.");
    page.section("What the cure costs");
    page.figure(
        costOfTheCure(results),
        "How much longer the robust form takes, beside how often the naive one fails without it. Left of "
        "1 it is faster. Of single answers: a whole picture also traverses, shades and stores.");
    page.section("Failure by failure");
    std::vector<ReportFigure> figures;
    for (const StabilityResult& result : results)
        figures.push_back({chartOf(result), fmt::format("{} {}", result.subject->id, result.subject->title),
                           captionOf(result)});
    page.figures(figures);
    page.section("All figures");
    page.paragraph(
        "Largest values over the sweep. Times are of one answer on one thread; the last ratio is a "
        "median over the values at which the naive form does not fail.");
    page.table(tableOf(results));
    return page.file();
}

}
