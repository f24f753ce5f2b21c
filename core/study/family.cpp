#include "core/study/family.h"

namespace eyeray {
namespace {

template <class Items, class GroupOf>
Groups grouped(const SampleRecord& record, const Items& items, const GroupOf& groupOf) {
    std::vector<int> groups;
    groups.reserve(items.size());
    for (const auto& item : items) groups.push_back(groupOf(item));
    return {record.rays.size(), groups};
}

}

Groups::Groups(std::size_t groups, std::span<const int> groupOf) : begins_(groups + 1, 0) {
    for (const int group : groupOf)
        if (group >= 0) ++begins_[static_cast<std::size_t>(group) + 1];
    for (std::size_t g = 0; g < groups; ++g) begins_[g + 1] += begins_[g];
    items_.resize(begins_[groups]);
    std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
    for (std::size_t i = 0; i < groupOf.size(); ++i)
        if (groupOf[i] >= 0) items_[next[static_cast<std::size_t>(groupOf[i])]++] = static_cast<int>(i);
}

Family::Family(const SampleRecord& record)
    : nextRays(grouped(record, record.rays,
                       [](const RayRecord& ray) { return ray.kind == RayKind::Shadow ? -1 : ray.parent; })),
      shadowRays(grouped(record, record.rays,
                         [](const RayRecord& ray) { return ray.kind == RayKind::Shadow ? ray.parent : -1; })),
      lamps(grouped(record, record.lamps, [](const LampTerm& lamp) { return lamp.ray; })),
      untraced(grouped(record, record.untraced, [](const UntracedRay& ray) { return ray.parent; })) {}

}
