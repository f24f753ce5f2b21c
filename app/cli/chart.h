#pragma once
// What `eyeray chart` makes of its measurements.

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/scene_files.h"
#include "core/study/experiment_run.h"
#include "core/study/plot.h"

namespace eyeray {

struct Chart {
    std::string scene; // as it is called
    ExperimentPlan plan;
    Experiment experiment;
    ErrorMetric metric = ErrorMetric::Rmse; // that is drawn
    int threads = 1;

    std::string pointName(const ExperimentPoint&) const; // "path d5 ×16"
    /// Whether each point is on the front of time and error to the fullest model.
    std::vector<bool> onFront() const;
};

/// Time against the error to each method's own limit, and against that to the fullest model.
std::vector<Plot> plotsOf(const Chart&);

/// A line for each point, all measures of its error with their extremes.
std::string csvOf(const Chart&);

/// A page with the charts, tables and pictures.
std::string reportOf(const Chart&);

/// The points and slopes as text for a terminal.
std::string textOf(const Chart&);

/// Pictures kept in the user's cache folder by the scene's own content, what they were rendered with, and
/// the program that did. What cannot be read or written there is made anew.
ReferenceStore referenceStore(const OpenedScene&, const ExperimentPlan&);

}
