#pragma once
// What the stability cases have shown, told: a table, a file of figures, a page.

#include <span>
#include <string>

#include "core/study/stability.h"

namespace eyeray {

/// A line for each case, for a terminal.
std::string stabilityText(std::span<const StabilityResult>);

/// A line for each case, value and form, under a line of names.
std::string stabilityCsv(std::span<const StabilityResult>);

/// One HTML page with a chart for each case and one of time against error; `circumstances` is a line that
/// says where and how it was measured.
std::string stabilityPage(std::span<const StabilityResult>, std::string_view circumstances);

}
