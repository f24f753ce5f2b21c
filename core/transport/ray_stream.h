#pragma once
// The rays of one depth of many samples, as columns: what is done to all of them is done to several at once.

#include <array>
#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/transport/medium_table.h"
#include "core/transport/tile_hits.h"

namespace eyeray {

inline constexpr std::size_t kStreamCapacity = 1024; // rays

/// Has room for the lanes of a register more. Registers that lie across two cache lines are read and written
/// more slowly.
template <class T>
struct alignas(64) Column : std::array<T, kStreamCapacity + 16> {};

/// Vectors of three, component by component.
struct Columns3 {
    Column<float> x, y, z;

    Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vec3& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

struct RayStream {
    std::size_t size = 0;
    std::size_t width = 0;        // of the rows of pixels that they go through; 0 if they lie otherwise
    Columns3 origin, direction;   // direction is unit
    Columns3 share;               // of a ray's radiance that its parent's hit sends on
    Columns3 weight;              // of its radiance that reaches the pixel
    Column<std::uint32_t> media;  // it runs in, by their number in the MediumTable
    Column<std::uint32_t> parent; // in the stream of the depth before
    Column<std::uint32_t> sample; // of the tile

    Column<float> t, u, v; // of hits, as in TileHits
    Column<std::uint32_t> primitive, instance;
    bool hitsKnown = false;                      // they are there already
    Column<std::uint32_t> order;                 // of those that hit something, by their bucket
    static constexpr std::size_t kBuckets = 256; // for materials, by their number modulo this
    std::array<std::uint32_t, kBuckets> ends{};  // of the buckets in `order`
    Columns3 direct, onward, transmitted;        // radiance of a ray = (direct + onward)·transmitted
};

/// What a thread needs to trace streams, kept from one tile to the next.
struct StreamMemory {
    std::vector<std::unique_ptr<RayStream>> streams; // by depth
    MediumTable media;                               // of all depths
    std::vector<int> treeNodes;                      // of each sample's tree
    Column<std::uint32_t> x{}, y{};                  // of each sample's pixel

    RayStream& stream(std::size_t depth) {
        while (streams.size() <= depth) streams.push_back(std::make_unique<RayStream>());
        return *streams[depth];
    }
};

}
