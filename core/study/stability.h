#pragma once
// Where methods of ray tracing fail, measured: for each failure (F01 to F64 of tests/STABILITY.md) that a
// function can show, the formula as taught beside what the renderer does, against a truth from a better
// source.

#include <array>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace eyeray {

/// Whose answer is judged.
enum class Form : std::uint8_t { NaiveFloat, NaiveDouble, Robust };
inline constexpr std::array<Form, 3> kForms = {Form::NaiveFloat, Form::NaiveDouble, Form::Robust};
inline constexpr std::array<std::string_view, 3> kFormNames = {"naive float", "naive double", "robust"};

/// How hard to look.
struct StabilityEffort {
    int trials =
        100'000; // rays, or what stands for them, for each form and parameter; costly ones make fewer
    bool timed = true;
    std::stop_token stop;
};

/// What one form does at one value of the parameter.
struct Measured {
    double error = 0;              // the largest of all finite answers, or as the case says
    double failuresPerMillion = 0; // trials
    double nanoseconds = 0;        // a trial, on one thread; 0: not timed
};
/// By Form; nothing where there is no such form.
using MeasuredForms = std::array<std::optional<Measured>, 3>;

/// What the robust form must keep to at every value of the parameter.
struct StabilityMark {
    double error = 0;
    double failuresPerMillion = 0;
};

struct StabilityCase {
    std::string_view id;                        // F01, …
    std::string_view title;                     // what goes wrong
    std::string_view why;                       // a line: how
    std::string_view fix;                       // a line: what the renderer does, and whose idea it is
    std::string_view parameter, error, failure; // what is swept, measured, and counted; with units
    std::vector<double> sweep;                  // ascending
    bool logarithmic = true;                    // the sweep
    bool showsFailures = false;                 // they tell more than the error
    StabilityMark mark;
    MeasuredForms (*measure)(double parameter, const StabilityEffort&) = nullptr;
};

/// All, by ascending id.
const std::vector<StabilityCase>& stabilityCases();

struct StabilityPoint {
    double parameter = 0;
    MeasuredForms forms;
};

struct StabilityResult {
    const StabilityCase* subject = nullptr;
    std::vector<StabilityPoint> points; // of the whole sweep, unless stop was requested

    /// The largest of each figure over the sweep; nothing if the case has no such form.
    std::optional<Measured> worst(Form) const;
    /// True if the robust form keeps to its mark wherever it was measured.
    bool passes() const;
    /// How many times longer the robust form takes than a naive one: median over the values at which the
    /// naive one does not fail (a miss is quickly found), or over all if it always does; nothing if not
    /// timed.
    std::optional<double> cost(Form naive) const;
};

/// Measures one case on the calling thread. Ends after the point at which stop is requested.
StabilityResult measureCase(const StabilityCase&, const StabilityEffort&);

}
