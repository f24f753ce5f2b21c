// Lanes in and out of the columns of a stream. Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_BATCH_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_BATCH_H
#undef EYERAY_STREAM_BATCH_H
#else
#define EYERAY_STREAM_BATCH_H
#endif

#include <algorithm>

#include "core/base/bit_lanes.h"
#include "core/base/lanes.h"
#include "core/transport/ray_stream.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

HWY_INLINE FloatLanes load(const Column<float>& column, std::size_t first) {
    return hn::LoadU(FloatTag(), &column[first]);
}
HWY_INLINE Vec3Lanes load(const Columns3& columns, std::size_t first) {
    return {load(columns.x, first), load(columns.y, first), load(columns.z, first)};
}
HWY_INLINE BitLanes load(const Column<std::uint32_t>& column, std::size_t first) {
    return hn::LoadU(BitTag(), &column[first]);
}
HWY_INLINE void store(FloatLanes values, Column<float>& column, std::size_t first) {
    hn::StoreU(values, FloatTag(), &column[first]);
}
HWY_INLINE void store(const Vec3Lanes& values, Columns3& columns, std::size_t first) {
    store(values.x, columns.x, first), store(values.y, columns.y, first), store(values.z, columns.z, first);
}
HWY_INLINE void store(IntLanes values, Column<std::uint32_t>& column, std::size_t first) {
    const BitTag b;
    hn::StoreU(hn::BitCast(b, values), b, &column[first]);
}
HWY_INLINE IntLanes loadInts(const Column<std::uint32_t>& column, std::size_t first) {
    return hn::BitCast(IntTag(), hn::LoadU(BitTag(), &column[first]));
}

/// Where the rays of a register lie in a stream: in lines of kBlockWidth, as pixels of a block of a picture
/// do.
struct BlockPlace {
    std::size_t first, stride; // from line to line
};
inline constexpr std::size_t kBlockWidth = std::min<std::size_t>(4, kLanes),
                             kBlockLines = kLanes / kBlockWidth;

template <class D>
HWY_INLINE hn::Vec<D> loadLines(D d, const hn::TFromD<D>* from, [[maybe_unused]] std::size_t stride) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (hn::MaxLanes(D()) > kBlockWidth) {
        const hn::Half<D> half;
        const auto* const upper = from + hn::MaxLanes(half) / kBlockWidth * stride;
        return hn::Combine(d, loadLines(half, upper, stride), loadLines(half, from, stride));
    }
#endif
    return hn::LoadU(d, from);
}
template <class D>
HWY_INLINE void storeLines(hn::Vec<D> values, D d, hn::TFromD<D>* to, [[maybe_unused]] std::size_t stride) {
#if HWY_TARGET != HWY_SCALAR
    if constexpr (hn::MaxLanes(D()) > kBlockWidth) {
        const hn::Half<D> half;
        auto* const upper = to + hn::MaxLanes(half) / kBlockWidth * stride;
        storeLines(hn::UpperHalf(half, values), half, upper, stride);
        return storeLines(hn::LowerHalf(half, values), half, to, stride);
    }
#endif
    hn::StoreU(values, d, to);
}

HWY_INLINE FloatLanes load(const Column<float>& column, BlockPlace at) {
    return loadLines(FloatTag(), &column[at.first], at.stride);
}
HWY_INLINE Vec3Lanes load(const Columns3& columns, BlockPlace at) {
    return {load(columns.x, at), load(columns.y, at), load(columns.z, at)};
}
HWY_INLINE void store(FloatLanes values, Column<float>& column, BlockPlace at) {
    storeLines(values, FloatTag(), &column[at.first], at.stride);
}
HWY_INLINE void store(IntLanes values, Column<std::uint32_t>& column, BlockPlace at) {
    const BitTag b;
    storeLines(hn::BitCast(b, values), b, &column[at.first], at.stride);
}

/// The first `count` lanes. Not BlendedStore, which is slow on AMD's processors without AVX-512.
HWY_INLINE void storeFirst(std::size_t count, const Vec3Lanes& values, Columns3& columns, std::size_t first) {
    store(select(hn::FirstN(FloatTag(), count), values, load(columns, first)), columns, first);
}
HWY_INLINE void storeFirst(std::size_t count, IntLanes values, Column<std::uint32_t>& column,
                           std::size_t first) {
    const auto there = hn::FirstN(IntTag(), count);
    store(hn::IfThenElse(there, values, loadInts(column, first)), column, first);
}

/// The lanes of the mask, close together; what comes after them is overwritten. Not CompressStore, which
/// is slow on AMD's processors.
HWY_INLINE void compress(FloatLanes values, FloatMask mask, Column<float>& column, std::size_t first) {
    hn::StoreU(compressed(values, mask), FloatTag(), &column[first]);
}
HWY_INLINE void compress(const Vec3Lanes& values, FloatMask mask, Columns3& columns, std::size_t first) {
    compress(values.x, mask, columns.x, first);
    compress(values.y, mask, columns.y, first);
    compress(values.z, mask, columns.z, first);
}
HWY_INLINE void compress(IntLanes values, FloatMask mask, Column<std::uint32_t>& column, std::size_t first) {
    store(compressed(values, mask), column, first);
}

/// Some rays of a stream that hit the same material.
struct Batch {
    std::size_t count;
    std::size_t first; // of them in the stream
    IntLanes rays;     // in the stream; the first again in lanes beyond `count`
    FloatMask active;
    bool together; // in the stream as here

    Batch(const Column<std::uint32_t>& order, std::size_t place, std::size_t size)
        : count(size), first(order[place]), active(hn::FirstN(FloatTag(), size)) {
        const IntTag n;
        const auto here = hn::RebindMask(n, active);
        rays = hn::IfThenElse(here, loadInts(order, place), hn::Set(n, static_cast<std::int32_t>(first)));
        together = hn::AllFalse(n, hn::And(here, rays != countedFrom(first)));
    }

    /// What a column has for these rays; anything in lanes beyond `count`.
    HWY_INLINE FloatLanes of(const Column<float>& column) const {
        return together ? load(column, first) : hn::GatherIndex(FloatTag(), column.data(), rays);
    }
    HWY_INLINE Vec3Lanes of(const Columns3& columns) const {
        return {of(columns.x), of(columns.y), of(columns.z)};
    }
    HWY_INLINE IntLanes of(const Column<std::uint32_t>& column) const {
        if (together) return loadInts(column, first);
        return hn::GatherIndex(IntTag(), reinterpret_cast<const std::int32_t*>(column.data()), rays);
    }
    /// Stores the values of the lanes with their rays.
    HWY_INLINE void put(const Vec3Lanes& values, Columns3& columns) const {
        if (together) return storeFirst(count, values, columns, first);
        const SpreadInt places = spread(rays);
        const Spread3 s = spread(values);
        for (std::size_t lane = 0; lane < count; ++lane) columns.set(places.at(lane), s.at(lane));
    }
};

}
HWY_AFTER_NAMESPACE();

#endif
