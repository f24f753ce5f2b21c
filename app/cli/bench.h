#pragma once
// What `eyeray bench` has measured, and how it is told.

#include <string>
#include <vector>

#include "core/study/ray_bench.h"

namespace eyeray {

/// One index, one kind of rays, one number of threads.
struct BenchFigure {
    std::size_t index = 0; // of BenchedScene::indices
    int threads = 1;
    RayKind kind = RayKind::Eye;
    std::size_t rays = 0, hits = 0; // of each round
    Series seconds;                 // of a round
    TraversalCounts counts;         // of as many of them as `counted`
    std::size_t counted = 0;

    double mraysPerSecond() const { return static_cast<double>(rays) * 1e-6 / seconds.median; }
};

struct BenchedScene {
    std::string reference;
    int side = 0; // of the square picture whose rays are traced, in pixels
    double loadSeconds = 0;
    std::vector<std::shared_ptr<const World>> indices;
    std::vector<BenchFigure> figures;
};

/// A table: a line for each index and number of threads, a column for each kind of rays.
std::string textOf(const BenchedScene&);

/// A list of an object for each figure, with at least the keys of `render --stats`.
std::string jsonOf(const std::vector<BenchedScene>&);

}
