#include "core/geometry/same_instances.h"

#include <algorithm>
#include <array>
#include <bit>

namespace eyeray {
namespace {

constexpr std::size_t kMostChanged = 16;

// By their bits: rays tell 0 from −0.
bool same(const Affine& a, const Affine& b) {
    using Bits = std::array<std::uint32_t, sizeof(Affine) / sizeof(std::uint32_t)>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

// All else that a placement holds is made from these two.
bool same(const Placement& a, const Placement& b) {
    return same(a.objectToWorld(), b.objectToWorld()) && same(a.worldToObject(), b.worldToObject());
}

bool same(const Sphere& a, const Sphere& b) { return a.radius == b.radius; }
bool same(const Plane& a, const Plane& b) {
    return a.sizeX == b.sizeX && a.sizeZ == b.sizeZ && a.doubleSided == b.doubleSided && a.round == b.round;
}
bool same(const Box& a, const Box& b) { return a.size == b.size; }
bool same(const Cylinder& a, const Cylinder& b) {
    return a.height == b.height && a.radiusTop == b.radiusTop && a.radiusBottom == b.radiusBottom;
}
bool same(const Shape& a, const Shape& b) {
    return std::visit(
        [&](const auto& shape) {
            const auto* const other = std::get_if<std::decay_t<decltype(shape)>>(&b);
            return other != nullptr && same(shape, *other);
        },
        a);
}

template <class Index>
bool same(const Instance<Index>& a, const Instance<Index>& b) {
    if (a.mask != b.mask || a.geometry.index() != b.geometry.index() || !same(a.placement, b.placement))
        return false;
    const Shape* const shape = std::get_if<Shape>(&a.geometry);
    return shape != nullptr ? same(*shape, *std::get_if<Shape>(&b.geometry))
                            : *std::get_if<1>(&a.geometry) == *std::get_if<1>(&b.geometry);
}

}

template <class Index>
bool sameInstances(std::span<const Instance<Index>> a, std::span<const Instance<Index>> b) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return same(x, y); });
}

std::optional<std::vector<Bounds>> changedBounds(const Accel& before, const Accel& after) {
    return std::visit(
        [&]<class Index>(const IndexedGeometry<Index>& old) -> std::optional<std::vector<Bounds>> {
            const auto* const now = std::get_if<IndexedGeometry<Index>>(&after);
            if (now == nullptr || old.instances.size() != now->instances.size()) return {};
            std::vector<Bounds> changed;
            for (std::size_t i = 0; i < old.instances.size(); ++i) {
                if (same(old.instances[i], now->instances[i])) continue;
                if (changed.size() >= 2 * kMostChanged) return {};
                changed.push_back(boundsOf(old.instances[i]));
                changed.push_back(boundsOf(now->instances[i]));
            }
            return changed;
        },
        before);
}

template bool sameInstances(std::span<const Instance<BruteForce>>, std::span<const Instance<BruteForce>>);
template bool sameInstances(std::span<const Instance<Bvh2>>, std::span<const Instance<Bvh2>>);
template bool sameInstances(std::span<const Instance<Bvh8>>, std::span<const Instance<Bvh8>>);

}
