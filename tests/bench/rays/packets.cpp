#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/rays/packets.cpp"
#include <hwy/foreach_target.h>

#include "core/geometry/accel_lanes.h"
#include "tests/bench/rays/packets.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// Rays in columns, as streams hold them.
class PacketColumns {
public:
    static constexpr std::size_t kMost = kMostRows * kLanes;

    explicit PacketColumns(std::span<const Ray> rays) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ray& ray = rays[i];
            for (int axis = 0; axis < 3; ++axis)
                origin_[axis][i] = ray.origin[axis], direction_[axis][i] = ray.direction[axis];
            tMin_[i] = ray.tMin, tMax_[i] = ray.tMax;
        }
        for (std::size_t i = 0; i < rays.size(); i += kLanes) {
            const auto at = [i](const auto& column) HWY_ATTR { return hn::Load(FloatTag(), &column[i]); };
            const auto three = [&](const auto& v)
                                   HWY_ATTR { return Vec3Lanes{at(v[0]), at(v[1]), at(v[2])}; };
            packet.add({three(origin_), three(direction_), at(tMin_), at(tMax_)},
                       bitsOf(hn::FirstN(FloatTag(), rays.size() - i)));
        }
    }

    PacketRays packet;

private:
    alignas(64) float origin_[3][kMost], direction_[3][kMost], tMin_[kMost], tMax_[kMost];
};

void closestHits(const IndexedGeometry<Bvh8>& geometry, std::span<const Ray> rays, std::span<float> answers) {
    const PacketColumns columns(rays);
    const Packet found(geometry, columns.packet, RayMask::All);
    for (std::size_t row = 0; row < columns.packet.count; ++row) {
        const auto rest = answers.subspan(row * kLanes);
        const Spread t = spread(found.hits(row).t);
        std::copy_n(t.lane, std::min(kLanes, rest.size()), rest.begin());
    }
}

void traceRays(const IndexedGeometry<Bvh8>& geometry, std::span<const Ray> rays, std::span<float> answers) {
    for (std::size_t first = 0; first < rays.size(); first += PacketColumns::kMost) {
        const std::size_t count = std::min(PacketColumns::kMost, rays.size() - first);
        closestHits(geometry, rays.subspan(first, count), answers.subspan(first, count));
    }
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(traceRays);

void bench::tracePackets(const IndexedGeometry<Bvh8>& geometry, std::span<const Ray> rays,
                         std::span<float> answers) {
    HWY_DYNAMIC_DISPATCH(traceRays)(geometry, rays, answers);
}

}
#endif
