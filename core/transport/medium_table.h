#pragma once
// The media of many rays: a ray carries a number instead of its stack.

#include <unordered_map>
#include <vector>

#include "core/transport/medium_stack.h"

namespace eyeray {

/// Every MediumStack that rays run in, once: stacks are equal where their numbers are. Not thread-safe.
class MediumTable {
public:
    /// Forgets all numbers and gives 0 to this stack.
    void reset(const MediumStack& first) {
        stacks_.clear(), numbers_.clear();
        numberOf(first);
    }
    const MediumStack& at(std::uint32_t number) const { return stacks_[number]; }
    std::uint32_t numberOf(const MediumStack& stack) {
        const auto [place, isNew] = numbers_.try_emplace(stack, static_cast<std::uint32_t>(stacks_.size()));
        if (isNew) stacks_.push_back(stack);
        return place->second;
    }

private:
    struct Hash {
        std::size_t operator()(const MediumStack& stack) const { return stack.hash(); }
    };
    std::vector<MediumStack> stacks_; // by number
    std::unordered_map<MediumStack, std::uint32_t, Hash> numbers_;
};

}
