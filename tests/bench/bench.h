#pragma once
// What the benchmarks share: series of measurements, and a line of a table for each.

#include <chrono>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "core/render/render_session.h"

namespace eyeray::bench {

using Clock = std::chrono::steady_clock;

inline constexpr int kWidth = 1280, kHeight = 720;

double secondsSince(Clock::time_point start);

/// What a series must reach: its 95th percentile, or its median.
struct Goal {
    enum class Of : std::uint8_t { None, Percentile95, Median } of = Of::None;
    double most = 0;
};

/// Prints `title` and the names of the columns.
void printHeading(const std::string& title, const std::string& unit);

/// Prints median, 95th percentile, least, largest, half the interquartile range (the spread) and count.
void printSeries(const std::string& name, std::vector<double> values, const Goal& goal = {});

/// The document of a built-in scene at 1280x720 that refines for as long as it may.
Document openForever(const std::string& scene);

/// Waits until the picture under way is coarse and whole; returns its status.
RenderStatus awaitCoarse(RenderSession&);

// one file each
void benchCoarse();
void benchCancel();
void benchFrames();
void benchPick();
void benchPictures();
void benchStart();
void benchSpheres();

}
