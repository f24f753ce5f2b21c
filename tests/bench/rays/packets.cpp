#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/rays/packets.cpp"
#include <hwy/foreach_target.h>

#include "core/geometry/accel_lanes.h"
#include "tests/bench/rays/packets.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

RayLanes rowAt(const bench::RayColumns& rays, std::size_t i) {
    const auto at = [i](const std::vector<float>& column)
                        HWY_ATTR { return hn::LoadU(FloatTag(), &column[i]); };
    const auto three = [&](const auto& v) HWY_ATTR { return Vec3Lanes{at(v[0]), at(v[1]), at(v[2])}; };
    return {three(rays.origin), three(rays.direction), at(rays.tMin), at(rays.tMax)};
}

void traceColumns(const IndexedGeometry<Bvh8>& geometry, const bench::RayColumns& rays,
                  std::span<float> answers) {
    for (std::size_t first = 0; first < rays.size; first += kMostRows * kLanes) {
        PacketRays packet;
        const auto place = [&](std::size_t row) { return first + row * kLanes; };
        for (std::size_t row = 0; row < kMostRows && place(row) < rays.size; ++row)
            packet.add(rowAt(rays, place(row)), bitsOf(hn::FirstN(FloatTag(), rays.size - place(row))));
        const Packet found(geometry, packet, RayMask::All);
        for (std::size_t row = 0; row < packet.count; ++row) {
            const auto rest = answers.subspan(place(row));
            const FloatLanes t = found.hits(row).t;
            if (rest.size() >= kLanes)
                hn::StoreU(t, FloatTag(), rest.data());
            else
                std::copy_n(spread(t).lane, rest.size(), rest.begin());
        }
    }
}

}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace eyeray {

HWY_EXPORT(traceColumns);

void bench::tracePackets(const IndexedGeometry<Bvh8>& geometry, const RayColumns& rays,
                         std::span<float> answers) {
    HWY_DYNAMIC_DISPATCH(traceColumns)(geometry, rays, answers);
}

}
#endif
