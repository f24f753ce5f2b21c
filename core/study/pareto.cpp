#include "core/study/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace eyeray {

std::vector<std::size_t> paretoFront(std::span<const Cost> costs) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (std::isfinite(costs[i].time) && std::isfinite(costs[i].error)) order.push_back(i);
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return std::tie(costs[a].time, costs[a].error, a) < std::tie(costs[b].time, costs[b].error, b);
    });
    double best = std::numeric_limits<double>::infinity();
    std::erase_if(order, [&](std::size_t i) {
        const bool beaten = costs[i].error >= best;
        best = std::min(best, costs[i].error);
        return beaten;
    });
    return order;
}

}
