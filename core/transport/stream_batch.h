// Lanes in and out of the columns of a stream. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_BATCH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_BATCH_H
#undef EYERAY_STREAM_BATCH_H
#else
#define EYERAY_STREAM_BATCH_H
#endif

#include "core/base/bit_lanes.h"
#include "core/base/lanes.h"
#include "core/transport/ray_stream.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

HWY_INLINE FloatLanes load(const std::vector<float>& column, std::size_t first) {
    return hn::LoadU(FloatTag(), &column[first]);
}
HWY_INLINE Vec3Lanes load(const Columns3& columns, std::size_t first) {
    return {load(columns.x, first), load(columns.y, first), load(columns.z, first)};
}
HWY_INLINE BitLanes load(const std::vector<std::uint32_t>& column, std::size_t first) {
    return hn::LoadU(BitTag(), &column[first]);
}
HWY_INLINE void store(FloatLanes values, std::vector<float>& column, std::size_t first) {
    hn::StoreU(values, FloatTag(), &column[first]);
}
HWY_INLINE void store(const Vec3Lanes& values, Columns3& columns, std::size_t first) {
    store(values.x, columns.x, first), store(values.y, columns.y, first), store(values.z, columns.z, first);
}
HWY_INLINE void store(IntLanes values, std::vector<std::uint32_t>& column, std::size_t first) {
    const hn::Rebind<std::uint32_t, DoubleTag> d;
    hn::StoreU(hn::BitCast(d, values), d, &column[first]);
}

/// The lanes of the mask, close together.
HWY_INLINE void compress(const Vec3Lanes& values, FloatMask mask, Columns3& columns, std::size_t first) {
    const FloatTag f;
    hn::CompressStore(values.x, mask, f, &columns.x[first]);
    hn::CompressStore(values.y, mask, f, &columns.y[first]);
    hn::CompressStore(values.z, mask, f, &columns.z[first]);
}

/// Some rays of a stream that hit the same material.
struct Batch {
    std::array<std::uint32_t, kLanes> ray; // in the stream; the first again in lanes beyond `count`
    std::size_t count = 0;
    IntLanes indices;
    FloatMask active;

    Batch(const std::uint32_t* order, std::size_t size) : count(size) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) ray[lane] = order[lane < size ? lane : 0];
        const hn::Rebind<std::uint32_t, DoubleTag> d;
        indices = hn::BitCast(IntTag(), hn::LoadU(d, ray.data()));
        active = hn::FirstN(FloatTag(), size);
    }

    HWY_INLINE FloatLanes of(const std::vector<float>& column) const {
        return hn::GatherIndex(FloatTag(), column.data(), indices);
    }
    HWY_INLINE Vec3Lanes of(const Columns3& columns) const {
        return {of(columns.x), of(columns.y), of(columns.z)};
    }
    HWY_INLINE IntLanes of(const std::vector<std::uint32_t>& column) const {
        alignas(64) std::int32_t values[kLanes];
        for (std::size_t lane = 0; lane < kLanes; ++lane)
            values[lane] = static_cast<std::int32_t>(column[ray[lane]]);
        return hn::Load(IntTag(), values);
    }
    /// Stores the values of the lanes with their rays.
    void put(const Vec3Lanes& values, Columns3& columns) const {
        const Spread3 s = spread(values);
        for (std::size_t lane = 0; lane < count; ++lane) columns.set(ray[lane], s.at(lane));
    }
};

}
HWY_AFTER_NAMESPACE();

#endif
