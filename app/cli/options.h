#pragma once
// What the command line asks for.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/document/document.h"
#include "core/study/hit_lines.h"
#include "core/study/measured_needs.h"

namespace eyeray {

/// Options of everything that renders.
struct PictureOptions {
    std::string scene;
    std::optional<int> width, height; // pixels
    std::vector<Command> commands;    // options that are settings, as commands, in order
    int firstPass = 0;
    bool stops = false; // --samples, --seconds or --error were given
};

struct ViewOptions {
    PictureOptions picture;
    std::optional<std::filesystem::path> widgets; // where the rectangles of widgets are written at each frame
};

inline constexpr const char* kAllLayers = "all";

struct RenderOptions {
    PictureOptions picture;
    std::filesystem::path output;
    std::optional<std::string> layer; // a layer's name, or kAllLayers
    std::optional<std::filesystem::path> stats;
    bool quiet = false;
};

struct SnapshotOptions {
    PictureOptions picture;
    std::filesystem::path output;
    int windowWidth = 1280, windowHeight = 720;
    std::optional<std::filesystem::path> play;
};

enum class InspectFormat : std::uint8_t { Text, Json, Csv, Svg };

struct InspectOptions {
    PictureOptions picture;
    PixelPosition pixel;
    int sample = 0;
    InspectFormat format = InspectFormat::Text;
    float leastWeight = 0;                       // of the rays in the SVG's tree
    std::optional<std::filesystem::path> output; // else standard output
};

struct HitsOptions {
    PictureOptions picture;
    HitQuestion question = HitQuestion::Closest;
};

struct BenchOptions {
    std::string scene;              // empty: the default ones
    double seconds = 10;            // about how long to measure
    std::optional<int> threads;     // else one, two, and one per core
    std::optional<AccelKind> accel; // else all that the scene is not too large for
    bool json = false;
};

struct StabilityOptions {
    std::filesystem::path folder; // of the report
    int rays = 300'000;           // of each form at each value
    bool json = false;
};

struct CompareOptions {
    std::filesystem::path reference, test;
    std::optional<std::filesystem::path> output; // of the difference picture
    bool json = false;
};

struct ChartOptions {
    PictureOptions picture;
    std::filesystem::path output;             // a folder
    std::map<std::string, std::string> lists; // of kChartLists, by key; empty: the default
    int repeats = 3;
    int referenceSamples = 0; // 0: by the most samples
    double limitSeconds = 30;
    double adaptiveError = kInvisibleError; // that adaptive sampling aims at
    std::string metric = "rmse";
    bool quiet = false;
};

struct NeedsOptions {
    PictureOptions picture;
    double tolerance = kDefaultTolerance;
    bool apply = false;
    std::filesystem::path output; // of the scene with the smaller settings, if it is to be applied
    bool json = false, quiet = false;
};

struct NameBugOptions {
    PictureOptions picture;
    std::filesystem::path wrong; // that came out wrong
    bool json = false;
};

struct ScenesOptions {};

using Options =
    std::variant<ViewOptions, RenderOptions, SnapshotOptions, InspectOptions, HitsOptions, BenchOptions,
                 StabilityOptions, CompareOptions, ChartOptions, NeedsOptions, NameBugOptions, ScenesOptions>;

/// What main does next: options to carry out, or an exit code after help or version have been printed.
/// Throws InputError for a wrong command line.
std::variant<Options, int> parseCommandLine(int argc, const char* const* argv);

}
