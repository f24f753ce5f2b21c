#pragma once
// Where the nodes of a drawn tree stand.

#include <span>
#include <vector>

namespace eyeray {

/// Breadth coordinate of each node's middle, from 0 for the outermost edge. A parent comes before its
/// children; parents[0] is −1. `breadths` are the nodes' own sizes, `gap` the least distance between two of a
/// level. Parents stand at the middle of their children, equal subtrees look the same, and nothing of a level
/// overlaps. Linear time: Buchheim, Jünger, Leipert 2002, "Improving Walker's Algorithm to Run in Linear
/// Time", after Reingold, Tilford 1981, "Tidier Drawings of Trees".
std::vector<double> tidyBreadths(std::span<const int> parents, std::span<const double> breadths, double gap);

}
