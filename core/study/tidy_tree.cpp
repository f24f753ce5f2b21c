#include "core/study/tidy_tree.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr int kNone = -1;

struct Node {
    std::vector<int> children;
    int parent = kNone, number = 0; // which child of its parent
    int thread = kNone, ancestor = kNone;
    double prelim = 0, mod = 0, shift = 0, change = 0;
};

/// The names are those of the paper.
class TidyTree {
public:
    TidyTree(std::span<const int> parents, std::span<const double> breadths, double gap)
        : nodes_(parents.size()), breadths_(breadths), gap_(gap) {
        for (std::size_t i = 0; i < parents.size(); ++i) {
            const int v = static_cast<int>(i);
            at(v).parent = parents[i];
            at(v).ancestor = v;
            if (parents[i] == kNone) continue;
            at(v).number = static_cast<int>(at(parents[i]).children.size());
            at(parents[i]).children.push_back(v);
        }
    }

    std::vector<double> place() {
        std::vector<double> middles(nodes_.size());
        if (nodes_.empty()) return middles;
        firstWalk(0);
        std::vector<double> mods(nodes_.size(), 0.0);
        double least = 0;
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const int parent = nodes_[i].parent;
            if (parent != kNone) mods[i] = mods[static_cast<std::size_t>(parent)] + at(parent).mod;
            middles[i] = nodes_[i].prelim + mods[i];
            const double edge = middles[i] - breadths_[i] / 2;
            least = i == 0 ? edge : std::min(least, edge);
        }
        for (double& middle : middles) middle -= least;
        return middles;
    }

private:
    Node& at(int v) { return nodes_[static_cast<std::size_t>(v)]; }

    double distance(int a, int b) const {
        return (breadths_[static_cast<std::size_t>(a)] + breadths_[static_cast<std::size_t>(b)]) / 2 + gap_;
    }
    int leftSibling(int v) {
        return at(v).number > 0 ? at(at(v).parent).children[static_cast<std::size_t>(at(v).number) - 1]
                                : kNone;
    }
    int nextLeft(int v) { return at(v).children.empty() ? at(v).thread : at(v).children.front(); }
    int nextRight(int v) { return at(v).children.empty() ? at(v).thread : at(v).children.back(); }

    void firstWalk(int v) {
        const int left = leftSibling(v);
        const double beside = left == kNone ? 0 : at(left).prelim + distance(left, v);
        if (at(v).children.empty()) {
            at(v).prelim = beside;
            return;
        }
        int defaultAncestor = at(v).children.front();
        for (const int w : at(v).children) {
            firstWalk(w);
            defaultAncestor = apportion(w, defaultAncestor);
        }
        executeShifts(v);
        const double middle = (at(at(v).children.front()).prelim + at(at(v).children.back()).prelim) / 2;
        at(v).prelim = left == kNone ? middle : beside;
        at(v).mod = at(v).prelim - middle;
    }

    /// Moves the subtree of v away from those of its left siblings, along their facing contours.
    int apportion(int v, int defaultAncestor) {
        if (leftSibling(v) == kNone) return defaultAncestor;
        int insideRight = v, outsideRight = v, insideLeft = leftSibling(v),
            outsideLeft = at(at(v).parent).children.front();
        double sumInsideRight = at(insideRight).mod, sumOutsideRight = at(outsideRight).mod,
               sumInsideLeft = at(insideLeft).mod, sumOutsideLeft = at(outsideLeft).mod;
        while (nextRight(insideLeft) != kNone && nextLeft(insideRight) != kNone) {
            insideLeft = nextRight(insideLeft);
            insideRight = nextLeft(insideRight);
            outsideLeft = nextLeft(outsideLeft);
            outsideRight = nextRight(outsideRight);
            at(outsideRight).ancestor = v;
            const double shift = at(insideLeft).prelim + sumInsideLeft - at(insideRight).prelim -
                                 sumInsideRight + distance(insideLeft, insideRight);
            if (shift > 0) {
                const int ancestor = at(insideLeft).ancestor;
                const bool sibling = at(ancestor).parent == at(v).parent;
                moveSubtree(sibling ? ancestor : defaultAncestor, v, shift);
                sumInsideRight += shift;
                sumOutsideRight += shift;
            }
            sumInsideLeft += at(insideLeft).mod;
            sumInsideRight += at(insideRight).mod;
            sumOutsideLeft += at(outsideLeft).mod;
            sumOutsideRight += at(outsideRight).mod;
        }
        if (nextRight(insideLeft) != kNone && nextRight(outsideRight) == kNone) {
            at(outsideRight).thread = nextRight(insideLeft);
            at(outsideRight).mod += sumInsideLeft - sumOutsideRight;
        }
        if (nextLeft(insideRight) != kNone && nextLeft(outsideLeft) == kNone) {
            at(outsideLeft).thread = nextLeft(insideRight);
            at(outsideLeft).mod += sumInsideRight - sumOutsideLeft;
            return v;
        }
        return defaultAncestor;
    }

    /// Siblings between the two share the movement.
    void moveSubtree(int from, int to, double shift) {
        const int subtrees = at(to).number - at(from).number;
        at(to).change -= shift / subtrees;
        at(from).change += shift / subtrees;
        at(to).shift += shift;
        at(to).prelim += shift;
        at(to).mod += shift;
    }

    void executeShifts(int v) {
        double shift = 0, change = 0;
        for (auto w = at(v).children.rbegin(); w != at(v).children.rend(); ++w) {
            at(*w).prelim += shift;
            at(*w).mod += shift;
            change += at(*w).change;
            shift += at(*w).shift + change;
        }
    }

    std::vector<Node> nodes_;
    std::span<const double> breadths_;
    double gap_;
};

}

std::vector<double> tidyBreadths(std::span<const int> parents, std::span<const double> breadths, double gap) {
    return TidyTree(parents, breadths, gap).place();
}

}
