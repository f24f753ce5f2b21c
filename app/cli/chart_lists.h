#pragma once
// The lists of settings that `eyeray chart` goes through.

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "core/study/experiment.h"

namespace eyeray {

struct ChartList {
    std::string_view key, help, usual;
};
inline constexpr std::array kChartLists = {
    ChartList{"methods", "of local, cast, whitted, distributed, path; all",
              "local,cast,whitted,distributed,path"},
    ChartList{"depths", "deepest rays, each 0 to 64; 1,5", "1,5"},
    ChartList{"cutoffs", "smallest contributions that are traced; 0.002", "0.002"},
    ChartList{"samples", "a pixel; 1,4,16", "1,4,16"},
    ChartList{"accels", "of auto, brute, bvh2, bvh8; auto", "auto"},
    ChartList{"samplers", "of independent, stratified, sobol; sobol", "sobol"},
    ChartList{"glass-shadows", "of opaque, straight, all; straight", "straight"},
    ChartList{"shadows", "shadow rays, of on, off; on", "on"},
    ChartList{"precisions", "of a --fault, of float, double; float", "float"},
    ChartList{"adaptive", "samples where the noise is, of off, on; off", "off"},
};

/// What all settings of an experiment are made from; a list that is missing or empty is the usual one.
/// Throws InputError for what is no list of the kind, and for too many points.
ExperimentGrid gridFrom(const std::map<std::string, std::string>& lists, const TraceSettings& base);

}
