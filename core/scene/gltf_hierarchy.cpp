// Where nodes are: the tree of the shown scene, walked without recursion.

#include <algorithm>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include "core/base/errors.h"
#include "core/scene/gltf_import.h"

namespace eyeray {

namespace {

constexpr int kRoot = -1;

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw InputError{where, what, "export the file again"};
}

void checkSize(const std::vector<double>& values, std::size_t size, const char* what,
               const std::string& where) {
    if (!values.empty() && values.size() != size)
        refuse(where, fmt::format("{} has not {} numbers", what, size));
}

DMat4 localTransform(const tinygltf::Node& node, const std::string& where) {
    checkSize(node.matrix, 16, "matrix", where);
    checkSize(node.translation, 3, "translation", where);
    checkSize(node.rotation, 4, "rotation", where);
    checkSize(node.scale, 3, "scale", where);

    DMat4 m(1);
    if (!node.matrix.empty()) {
        for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[i];
        if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
            refuse(where, "matrix is no movement: its last row is not 0 0 0 1");
        return m;
    }
    if (const auto& r = node.rotation; !r.empty()) {
        const glm::dquat quaternion(r[3], r[0], r[1], r[2]);
        const double length = glm::length(quaternion);
        if (!(length > 0) || !std::isfinite(length)) refuse(where, "rotation is no rotation");
        m = glm::mat4_cast(quaternion / length);
    }
    if (const auto& s = node.scale; !s.empty())
        for (int i = 0; i < 3; ++i) m[i] *= s[i];
    if (const auto& t = node.translation; !t.empty()) m[3] = DVec4(t[0], t[1], t[2], 1);
    return m;
}

void checkSane(const DMat4& m, const std::string& where) {
    for (int i = 0; i < 16; ++i)
        if (!(std::fabs(m[i / 4][i % 4]) <= limits::kNumber)) refuse(where, "lies or reaches too far out");
}

/// The parent of each node. Throws if one has two, or a child does not exist.
std::vector<int> parentsOf(const GltfDocument& document) {
    const auto& nodes = document.model.nodes;
    std::vector<int> parents(nodes.size(), kRoot);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const int child : nodes[i].children) {
            if (static_cast<std::size_t>(child) >= nodes.size())
                refuse(document.at("nodes", i), fmt::format("child {} does not exist", child));
            if (parents[child] != kRoot)
                refuse(document.at("nodes", static_cast<std::size_t>(child)), "has two parents");
            parents[child] = static_cast<int>(i);
        }
    return parents;
}

std::vector<int> rootsOf(const GltfDocument& document, const std::vector<int>& parents) {
    const tinygltf::Scene* const scene = shownScene(document);
    std::vector<int> roots;
    if (!scene) {
        for (std::size_t i = 0; i < parents.size(); ++i)
            if (parents[i] == kRoot) roots.push_back(static_cast<int>(i));
        return roots;
    }
    std::vector<bool> placed(parents.size(), false);
    for (const int root : scene->nodes) {
        if (static_cast<std::size_t>(root) >= parents.size())
            refuse(document.where, fmt::format("its scene shows node {}, which does not exist", root));
        if (parents[root] != kRoot || placed[root])
            refuse(document.at("nodes", static_cast<std::size_t>(root)), "is placed twice");
        placed[root] = true;
        roots.push_back(root);
    }
    return roots;
}

/// With one parent each, a chain upwards that never ends is a cycle.
void checkDepths(const GltfDocument& document, const std::vector<int>& parents) {
    for (std::size_t i = 0; i < parents.size(); ++i) {
        int depth = 0;
        for (int up = static_cast<int>(i); up != kRoot; up = parents[up])
            if (++depth > limits::kNodeDepth)
                refuse(document.at("nodes", i),
                       fmt::format("lies on a cycle, or deeper than {} nodes", limits::kNodeDepth));
    }
}

}

std::vector<PlacedNode> placeNodes(const GltfDocument& document, GltfNotes& notes) {
    const auto& nodes = document.model.nodes;
    const std::vector<int> parents = parentsOf(document);
    checkDepths(document, parents);
    if (document.model.scenes.size() > 1)
        notes.ignored(fmt::format("other scenes are not shown ({})", document.model.scenes.size() - 1));

    std::vector<PlacedNode> placed, open;
    for (const int root : rootsOf(document, parents)) open.push_back({root, DMat4(1)});
    while (!open.empty()) {
        PlacedNode next = open.back();
        open.pop_back();
        const std::string where = document.at("nodes", static_cast<std::size_t>(next.node));
        next.transform = next.transform * localTransform(nodes[next.node], where);
        checkSane(next.transform, where);
        for (const int child : nodes[next.node].children) open.push_back({child, next.transform});
        placed.push_back(next);
    }
    std::sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
    return placed;
}

}
