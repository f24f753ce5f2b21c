#include "core/study/index_picture.h"

#include <algorithm>
#include <unordered_map>

#include "core/study/bvh_parts.h"

namespace eyeray {
namespace {

using Role = SpaceBox::Role;

constexpr std::size_t kMostOfALevel = 1U << 20U; // boxes; meshes that are placed very often have more

std::array<Vec3, 8> cornersOf(const Bounds& box) {
    std::array<Vec3, 8> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = Vec3((i & 1U) != 0 ? box.hi.x : box.lo.x, (i & 2U) != 0 ? box.hi.y : box.lo.y,
                          (i & 4U) != 0 ? box.hi.z : box.lo.z);
    return corners;
}

double sizeOf(const SpaceBox& box) { return glm::length(DVec3(box.corners[7]) - DVec3(box.corners[0])); }

/// Leaves the largest.
void limit(IndexPicture& picture) {
    const auto cut = [&](auto& items, const auto& larger) {
        if (items.size() <= kMostIndexBoxes) return;
        const auto end = items.begin() + static_cast<std::ptrdiff_t>(kMostIndexBoxes);
        std::nth_element(items.begin(), end, items.end(), larger);
        picture.leftOut += items.size() - kMostIndexBoxes;
        items.resize(kMostIndexBoxes);
    };
    cut(picture.boxes, [](const SpaceBox& a, const SpaceBox& b) { return sizeOf(a) > sizeOf(b); });
    cut(picture.triangles, [](const auto& a, const auto& b) {
        const auto area = [](const auto& t) { return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); };
        return area(a) > area(b);
    });
}

template <class Index>
const IndexedMesh<Index>* meshOf(const Instance<Index>& instance) {
    const auto* mesh = std::get_if<1>(&instance.geometry);
    return mesh != nullptr ? mesh->get() : nullptr;
}

/// Looks at the trees of one kind of index.
template <class Index>
class Trees {
public:
    explicit Trees(const IndexedGeometry<Index>& geometry) : geometry_(geometry) {}

    int levels() const {
        std::unordered_map<const IndexedMesh<Index>*, int> ofMesh;
        const auto below = [&](std::uint32_t id) {
            const IndexedMesh<Index>* mesh = meshOf(geometry_.instances[id]);
            if (mesh == nullptr) return 0;
            const auto [known, isNew] = ofMesh.try_emplace(mesh, 0);
            if (isNew) known->second = depthOf(mesh->index, [](std::uint32_t) { return 0; });
            return known->second;
        };
        int levels = depthOf(geometry_.top, below);
        for (const std::uint32_t id : geometry_.always) levels = std::max(levels, below(id));
        return levels;
    }

    IndexPicture level(int wanted) const {
        std::vector<Placed> now = roots();
        for (int level = 0; level < wanted; ++level) {
            std::vector<Placed> next;
            for (const Placed& placed : now) addBelow(placed, next);
            now = std::move(next);
        }
        IndexPicture picture;
        for (const Placed& placed : now)
            picture.boxes.push_back(
                boxOf(placed.tree == kTopLevel ? Role::TopLevel : Role::Mesh, placed.tree, placed.part.box));
        return picture;
    }

    IndexPicture tested(const TraversalLog& log) const {
        IndexPicture picture;
        for (const BoxTests& tests : log.boxes) {
            const Index& tree = treeOf(tests.tree);
            const auto parts =
                tests.node == BoxTests::kRoot ? std::vector{rootOf(tree)} : partsBelow(tree, tests.node);
            for (std::size_t i = 0; i < parts.size(); ++i)
                picture.boxes.push_back(
                    boxOf((tests.met >> i & 1U) != 0 ? Role::Met : Role::Missed, tests.tree, parts[i].box));
        }
        return picture;
    }

private:
    struct Placed {
        std::uint32_t tree; // an instance, or kTopLevel
        TreePart part;
    };

    const Index& treeOf(std::uint32_t tree) const {
        return tree == kTopLevel ? geometry_.top : std::get<1>(geometry_.instances[tree].geometry)->index;
    }

    SpaceBox boxOf(Role role, std::uint32_t tree, const Bounds& box) const {
        SpaceBox result{role, cornersOf(box)};
        if (tree != kTopLevel)
            for (Vec3& corner : result.corners) corner = geometry_.instances[tree].placement.toWorld(corner);
        return result;
    }

    /// Levels of a tree and of what is below the slots of its leaves.
    template <class Below>
    static int depthOf(const Index& tree, const Below& below) {
        if (tree.nodes().empty()) return 0;
        int deepest = 0;
        std::vector<std::pair<TreePart, int>> open{{rootOf(tree), 1}};
        while (!open.empty()) {
            const auto [part, depth] = open.back();
            open.pop_back();
            deepest = std::max(deepest, depth);
            if (!part.leaf)
                for (const TreePart& next : partsBelow(tree, part.node)) open.emplace_back(next, depth + 1);
            else
                for (std::uint32_t slot = part.first; slot < part.first + part.count; ++slot)
                    deepest = std::max(deepest, depth + below(tree.entries()[slot]));
        }
        return deepest;
    }

    void addRoot(std::uint32_t id, std::vector<Placed>& list) const {
        const IndexedMesh<Index>* mesh = meshOf(geometry_.instances[id]);
        if (mesh != nullptr && !mesh->index.nodes().empty()) list.push_back({id, rootOf(mesh->index)});
    }

    std::vector<Placed> roots() const {
        std::vector<Placed> list;
        if (!geometry_.top.nodes().empty()) list.push_back({kTopLevel, rootOf(geometry_.top)});
        for (const std::uint32_t id : geometry_.always) addRoot(id, list);
        return list;
    }

    void addBelow(const Placed& placed, std::vector<Placed>& list) const {
        if (list.size() >= kMostOfALevel) return;
        const TreePart& part = placed.part;
        if (!part.leaf) {
            for (const TreePart& next : partsBelow(treeOf(placed.tree), part.node))
                list.push_back({placed.tree, next});
        } else if (placed.tree == kTopLevel) {
            for (std::uint32_t slot = part.first; slot < part.first + part.count; ++slot)
                addRoot(geometry_.top.entries()[slot], list);
        }
    }

    const IndexedGeometry<Index>& geometry_;
};

template <class Index>
void addPrimitives(const IndexedGeometry<Index>& geometry, const TraversalLog& log, IndexPicture& picture) {
    for (const PrimitiveTest& test : log.primitives) {
        const Instance<Index>& instance = geometry.instances[test.instance];
        const auto toWorld = [&](auto& points) {
            for (Vec3& point : points) point = instance.placement.toWorld(point);
            return points;
        };
        if (const IndexedMesh<Index>* mesh = meshOf(instance)) {
            std::array<Vec3, 3> triangle;
            for (std::size_t i = 0; i < 3; ++i)
                triangle[i] = mesh->mesh->positions[mesh->mesh->triangles[test.primitive][i]];
            picture.triangles.push_back(toWorld(triangle));
            continue;
        }
        const Bounds box = boundsOf(std::get<Shape>(instance.geometry));
        if (!box.finite()) continue;
        auto corners = cornersOf(box);
        picture.boxes.push_back({Role::Tested, toWorld(corners)});
    }
}

/// What `look` finds in the World's trees; an empty Result where there are none.
template <class Result, class Look>
Result inTrees(const World& world, const Look& look) {
    return std::visit(
        [&]<class Index>(const IndexedGeometry<Index>& geometry) -> Result {
            if constexpr (std::is_same_v<Index, BruteForce>)
                return {};
            else
                return look(Trees<Index>(geometry));
        },
        *world.accel);
}

}

int levelsOf(const World& world) {
    return inTrees<int>(world, [](const auto& trees) { return trees.levels(); });
}

IndexPicture boxesOfLevel(const World& world, int level) {
    auto picture = inTrees<IndexPicture>(world, [&](const auto& trees) { return trees.level(level); });
    limit(picture);
    return picture;
}

IndexPicture pictureOf(const World& world, const TraversalLog& log) {
    auto picture = inTrees<IndexPicture>(world, [&](const auto& trees) { return trees.tested(log); });
    std::visit([&](const auto& geometry) { addPrimitives(geometry, log, picture); }, *world.accel);
    limit(picture);
    return picture;
}

}
