#pragma once
// Which of several offers are worth their price.

#include <cstddef>
#include <span>
#include <vector>

namespace eyeray {

struct Cost {
    double time = 0, error = 0;
};

/// The offers that no other beats: none is at most as slow and at most as wrong, and better in one of both.
/// Their indices by ascending time; of equal offers the first. What is not finite is no offer. V. Pareto
/// 1906, "Manuale di economia politica".
std::vector<std::size_t> paretoFront(std::span<const Cost>);

}
