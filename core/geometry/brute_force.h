#pragma once
// An index that finds nothing out: every entry is a candidate of every ray. The oracle for the others.

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/geometry/bounds.h"
#include "core/geometry/ray.h"
#include "core/geometry/traversal_log.h"

namespace eyeray {

class BruteForce {
public:
    BruteForce() = default;
    /// Takes the boxes that are finite and not empty. `leafSize` is of no meaning here.
    BruteForce(std::span<const Bounds> boxes, int /*leafSize*/, const std::stop_token&) {
        for (std::uint32_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].finite() && !boxes[i].empty()) entries_.push_back(i);
    }

    /// Calls test(slot) for each entry until it returns true; whether it did. No log hears of a node or box.
    template <class Test, class Log = Unwatched>
    bool visit(const Ray&, const float& /*limit*/, Test&& test, Log /*log*/ = {}) const {
        for (std::uint32_t slot = 0; slot < entries_.size(); ++slot)
            if (test(slot)) return true;
        return false;
    }

    /// Which box each slot stands for.
    std::span<const std::uint32_t> entries() const { return entries_; }
    /// How many boxes it holds.
    std::size_t size() const { return entries_.size(); }
    std::size_t nodeCount() const { return 0; }
    std::size_t bytes() const { return entries_.size() * sizeof(std::uint32_t); }

private:
    std::vector<std::uint32_t> entries_;
};

}
