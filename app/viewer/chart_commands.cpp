#include "app/viewer/chart_commands.h"

#include <fmt/format.h>

#include "app/document/user_folders.h"
#include "app/viewer/viewer.h"
#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/study/palette.h"

namespace eyeray {
namespace {

std::size_t curveOf(const Viewer& viewer, const Command& command) {
    command.required("n");
    const int last = viewer.recording().current();
    if (last < 0)
        throw InputError(command.text(), "there is no curve", "say chart on=on and let a picture refine");
    return static_cast<std::size_t>(*command.integer("n", 0, last));
}

}

void curve(Viewer& viewer, const Command& command) {
    command.allowOnly({"n", "name", "color", "pin"});
    const std::size_t n = curveOf(viewer, command);
    ChartRecording& recording = viewer.recording();
    const auto color = command.integer("color", 0, static_cast<int>(kSeriesColors) - 1);
    const auto pin = command.flag("pin");
    if (const auto name = command.find("name")) recording.rename(n, printable(*name, 60));
    if (color) recording.recolor(n, *color);
    if (pin) recording.pin(n, *pin);
}

void curveReturn(Viewer& viewer, const Command& command) {
    command.allowOnly({"n"});
    viewer.returnTo(curveOf(viewer, command));
}

void curveRemove(Viewer& viewer, const Command& command) {
    command.allowOnly({"n"});
    viewer.recording().remove(curveOf(viewer, command));
}

void chartReference(Viewer& viewer, const Command& command) {
    command.allowOnly({"n"});
    if (command.find("n"))
        viewer.recording().takeReference(curveOf(viewer, command));
    else
        viewer.recording().dropReference();
}

void chartSave(Viewer& viewer, const Command& command) {
    command.allowOnly({"file", "format"});
    constexpr std::array<std::string_view, 2> kFormats = {"svg", "csv"};
    const std::string ending = command.choice("format", kFormats).value_or(0) == 1 ? ".csv" : ".svg";
    const std::filesystem::path file = command.find("file")
                                           ? std::filesystem::path(*command.find("file"))
                                           : freeName(picturesFolder(), "eyeray-chart", ending);
    const bool asCsv = file.extension() == ".csv";
    if (!asCsv && file.extension() != ".svg")
        throw InputError(file.string(), "a chart is saved as .svg or .csv", "end its name in one of them");
    Plot plot = plotOf(viewer.recording());
    if (plot.series.empty())
        throw InputError(command.text(), "there are no points yet",
                         "say chart on=on and let a picture refine");
    plot.title = fmt::format("{}: time against error", viewer.opened().reference);
    const std::string text = asCsv ? csvOf(viewer.recording()) : svgOf(plot);
    writeFileAtomically(file, std::as_bytes(std::span(text)));
    viewer.report(Notice::Kind::Done, fmt::format("chart saved as {}", file.string()));
}

}
