#include "core/study/tree_diagram.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/study/family.h"
#include "core/study/tidy_tree.h"
#include "core/study/wording.h"

namespace eyeray {
namespace {

constexpr float kNodeWidth = 12.5F, kTallNode = 2.9F, kFlatNode = 1.6F;
constexpr float kEdgeLength = 4.2F; // room for its weight
constexpr float kGap = 0.55F;       // between nodes above each other
constexpr float kAbove = 0.35F;     // of a label above the line that it stands on
constexpr std::size_t kMostLetters = 18;

/// At most kMostLetters letters of UTF-8 text.
std::string shortened(const std::string& text) {
    std::size_t letters = 0, cut = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) continue;
        if (++letters == kMostLetters) cut = i;
    }
    return letters > kMostLetters ? text.substr(0, cut) + "…" : text;
}

class Builder {
public:
    Builder(const SampleRecord& record, const Scene& scene, const TreeFilter& filter)
        : record_(record), scene_(scene), filter_(filter), family_(record) {}

    TreeDiagram build() {
        if (!record_.rays.empty()) ray(0, -1, 0);
        std::vector<int> parents;
        std::vector<double> heights;
        for (const DiagramNode& node : diagram_.nodes) {
            parents.push_back(node.parent);
            heights.push_back(node.height);
        }
        const std::vector<double> middles = tidyBreadths(parents, heights, kGap);
        for (std::size_t i = 0; i < diagram_.nodes.size(); ++i) {
            DiagramNode& node = diagram_.nodes[i];
            node.y = static_cast<float>(middles[i]) - node.height / 2;
            diagram_.width = std::max(diagram_.width, node.x + node.width);
            diagram_.height = std::max(diagram_.height, node.y + node.height);
        }
        return std::move(diagram_);
    }

private:
    const RayRecord& at(int ray) const { return record_.rays[static_cast<std::size_t>(ray)]; }

    int place(DiagramNode node, int parent, int level) {
        node.parent = parent;
        node.x = static_cast<float>(level) * (kNodeWidth + kEdgeLength);
        node.width = kNodeWidth;
        node.height = node.detail.empty() ? kFlatNode : kTallNode;
        node.title = shortened(node.title);
        diagram_.nodes.push_back(std::move(node));
        return static_cast<int>(diagram_.nodes.size()) - 1;
    }

    void ray(int index, int parent, int level) {
        const RayRecord& r = at(index);
        const int node = place({.ray = index,
                                .kind = r.kind,
                                .title = meeting(scene_, r),
                                .detail = r.end == RayEnd::Hit ? "t = " + metresText(r.t) : "background",
                                .edge = weightText(r.weight),
                                .radiance = r.radiance},
                               parent, level);
        if (filter_.isCollapsed(index)) {
            diagram_.nodes[static_cast<std::size_t>(node)].hidden = descendants(index);
            return;
        }
        const int before = static_cast<int>(diagram_.nodes.size());
        for (const int shadow : family_.shadowRays[index])
            if (filter_.shows(at(shadow))) shadowRay(shadow, node, level + 1);
        for (const int next : family_.nextRays[index]) {
            if (filter_.shows(at(next))) ray(next, node, level + 1);
            if (at(next).totalReflection) noRefraction(index, at(next), node, level + 1);
        }
        for (const int missing : family_.untraced[index]) {
            const UntracedRay& untraced = record_.untraced[static_cast<std::size_t>(missing)];
            if (filter_.shows(untraced)) untracedRay(untraced, node, level + 1);
        }
        if (static_cast<int>(diagram_.nodes.size()) == before)
            diagram_.nodes[static_cast<std::size_t>(node)].hidden = descendants(index);
    }

    void shadowRay(int index, int parent, int level) {
        const RayRecord& r = at(index);
        const bool blocked = r.end == RayEnd::Blocked;
        place({.ray = index,
               .kind = RayKind::Shadow,
               .faint = blocked,
               .title = fmt::format("{}: {}", lampName(scene_, r.light), blocked ? "blocked" : "lit"),
               .detail = {},
               .edge = weightText(r.weight),
               .radiance = r.radiance},
              parent, level);
    }

    void noRefraction(int at, const RayRecord& reflection, int parent, int level) {
        if (!filter_.untraced || !filter_.kinds[static_cast<std::size_t>(RayKind::Refraction)] ||
            !filter_.shows(reflection))
            return;
        place({.ray = at,
               .kind = RayKind::Refraction,
               .traced = false,
               .faint = true,
               .title = "no refraction:",
               .detail = std::string(kTotalReflectionText),
               .edge = {}},
              parent, level);
    }

    void untracedRay(const UntracedRay& untraced, int parent, int level) {
        place({.ray = untraced.parent,
               .kind = untraced.kind,
               .traced = false,
               .faint = true,
               .title = fmt::format("no {}:", name(untraced.kind)),
               .detail = std::string(reasonText(untraced.reason)),
               .edge = weightText(untraced.weight)},
              parent, level);
    }

    int descendants(int index) const {
        auto count = static_cast<int>(family_.shadowRays[index].size() + family_.untraced[index].size());
        for (const int next : family_.nextRays[index]) count += 1 + descendants(next);
        return count;
    }

    const SampleRecord& record_;
    const Scene& scene_;
    const TreeFilter& filter_;
    const Family family_;
    TreeDiagram diagram_;
};

}

bool TreeFilter::shows(const RayRecord& ray) const {
    return kinds[static_cast<std::size_t>(ray.kind)] && maxComponent(ray.weight) >= leastWeight;
}

bool TreeFilter::shows(const UntracedRay& ray) const {
    return untraced && kinds[static_cast<std::size_t>(ray.kind)] && maxComponent(ray.weight) >= leastWeight;
}

bool TreeFilter::isCollapsed(int ray) const {
    return std::binary_search(collapsed.begin(), collapsed.end(), ray);
}

TreeDiagram diagramOf(const SampleRecord& record, const Scene& scene, const TreeFilter& filter) {
    return Builder(record, scene, filter).build();
}

std::array<Vec2, 4> edgeCurve(const TreeDiagram& diagram, const DiagramNode& node) {
    const DiagramNode& parent = diagram.nodes[static_cast<std::size_t>(node.parent)];
    const Vec2 from{parent.x + parent.width, parent.y + parent.height / 2};
    const Vec2 to{node.x, node.y + node.height / 2};
    const Vec2 bend{(to.x - from.x) * 0.5F, 0};
    return {from, from + bend, to - bend, to};
}

Vec2 edgeLabel(const TreeDiagram& diagram, const DiagramNode& node) {
    const auto curve = edgeCurve(diagram, node);
    const bool falls = curve[3].y > curve[0].y + kAbove;
    return curve[3] + Vec2(-0.35F, falls ? 0.95F : -kAbove);
}

Vec2 pointOf(const std::array<Vec2, 4>& c, float s) {
    const float r = 1 - s;
    return r * r * r * c[0] + 3 * r * r * s * c[1] + 3 * r * s * s * c[2] + s * s * s * c[3];
}

}
