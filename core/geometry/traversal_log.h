#pragma once
// What a ray goes through in an index.

#include <cstdint>
#include <span>
#include <vector>

namespace eyeray {

/// How much work a ray, or several, made for an index.
struct TraversalCounts {
    std::uint64_t nodes = 0;      // nodes gone into, of those that nodeCount() counts
    std::uint64_t boxes = 0;      // boxes tested against the ray
    std::uint64_t primitives = 0; // triangles and shapes tested against the ray

    TraversalCounts& operator+=(const TraversalCounts& other) {
        nodes += other.nodes;
        boxes += other.boxes;
        primitives += other.primitives;
        return *this;
    }
    friend bool operator==(const TraversalCounts&, const TraversalCounts&) = default;
};

/// Stands for the tree over the instances, where others are named by the instance whose mesh they are over.
inline constexpr std::uint32_t kTopLevel = 0xffffffff;

/// Boxes that were tested: those of the children of one node, or the root's own.
struct BoxTests {
    static constexpr std::uint32_t kRoot = 0xffffffff;

    std::uint32_t tree; // an instance, or kTopLevel
    std::uint32_t node; // whose children they are, or kRoot
    std::uint32_t met;  // a bit for each: the ray may meet it
};

struct PrimitiveTest {
    std::uint32_t instance;
    std::uint32_t primitive; // triangle of a mesh; 0 for a shape
};

/// What rays went through, in order; or the counts alone.
struct TraversalLog {
    bool countsOnly = false;
    TraversalCounts counts;
    std::vector<BoxTests> boxes;
    std::vector<PrimitiveTest> primitives;
};

/// What a traversal writes its log with.
class Watched {
public:
    explicit Watched(TraversalLog& log) : log_(&log) {}

    /// For the tree of an instance's mesh.
    Watched into(std::uint32_t instance) const {
        Watched inside = *this;
        inside.tree_ = instance;
        return inside;
    }
    void node() const { ++log_->counts.nodes; }
    void boxes(std::uint32_t node, unsigned tested, std::uint32_t met) const {
        log_->counts.boxes += tested;
        if (!log_->countsOnly) log_->boxes.push_back({tree_, node, met});
    }
    void triangle(std::uint32_t number) const { primitive(tree_, number); }
    void shape(std::uint32_t instance) const { primitive(instance, 0); }

private:
    void primitive(std::uint32_t instance, std::uint32_t number) const {
        ++log_->counts.primitives;
        if (!log_->countsOnly) log_->primitives.push_back({instance, number});
    }

    TraversalLog* log_;
    std::uint32_t tree_ = kTopLevel;
};

/// Writes none, and costs nothing: what rendering uses.
struct Unwatched {
    static Unwatched into(std::uint32_t /*instance*/) { return {}; }
    static void node() {}
    static void boxes(std::uint32_t /*node*/, unsigned /*tested*/, std::uint32_t /*met*/) {}
    static void triangle(std::uint32_t /*number*/) {}
    static void shape(std::uint32_t /*instance*/) {}
};

}
