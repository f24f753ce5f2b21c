#include "core/geometry/collapse.h"

#include <algorithm>

namespace eyeray {

Collapse::Collapse(std::span<const Bvh2::Node> binary) : binary_(binary), costs_(binary.size()) {
    for (std::size_t i = binary.size(); i-- > 0;) {
        const Bvh2::Node& node = binary[i];
        if (node.count > 0) continue; // whatever is chosen, rays come to the same leaves
        Costs& costs = costs_[i];
        costs = sideBySide(costs_[node.first], costs_[node.first + 1]);
        const float asOne = node.bounds().halfArea() + costs.back();
        for (float& cost : costs) cost = std::min(cost, asOne);
    }
}

/// Least cost of both trees as up to i + 1 children in all; infinite for one.
Collapse::Costs Collapse::sideBySide(const Costs& left, const Costs& right) {
    Costs least;
    least.fill(kInfinity);
    for (std::size_t l = 0; l + 1 < least.size(); ++l)
        for (std::size_t r = 0; l + r + 1 < least.size(); ++r)
            least[l + r + 1] = std::min(least[l + r + 1], left[l] + right[r]);
    return least;
}

Collapse::Children Collapse::childrenOf(std::uint32_t node) const {
    Children children;
    if (binary_[node].count > 0)
        gather(node, 1, children);
    else
        gatherBelow(node, cheapest(node, Bvh8::kWidth), Bvh8::kWidth, children);
    return children;
}

Collapse::Share Collapse::cheapest(std::uint32_t node, std::size_t lanes) const {
    const std::uint32_t left = binary_[node].first;
    Share best{1, costs_[left][0] + costs_[left + 1][lanes - 2]};
    for (std::size_t toLeft = 2; toLeft < lanes; ++toLeft) {
        const float cost = costs_[left][toLeft - 1] + costs_[left + 1][lanes - toLeft - 1];
        if (cost < best.cost) best = {toLeft, cost};
    }
    return best;
}

void Collapse::gather(std::uint32_t node, std::size_t lanes, Children& children) const {
    if (lanes > 1 && binary_[node].count == 0) {
        const Share share = cheapest(node, lanes);
        if (!(costs_[node][0] < share.cost)) // equal where there is no area: fewer nodes are better
            return gatherBelow(node, share, lanes, children);
    }
    children.node[children.count++] = node;
}

void Collapse::gatherBelow(std::uint32_t node, const Share& share, std::size_t lanes,
                           Children& children) const {
    const std::uint32_t left = binary_[node].first;
    gather(left, share.toLeft, children);
    gather(left + 1, lanes - share.toLeft, children);
}

}
