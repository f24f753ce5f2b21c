#pragma once
// What is wrong on purpose in code that is specialised for it: rendering uses NoFaults, which costs nothing.

#include <type_traits>

#include "core/base/fault.h"
#include "core/base/sampling.h"
#include "core/geometry/textbook_geometry.h"

namespace eyeray {

struct NoFaults {
    NoFaults() = default;
    explicit NoFaults(FaultSet) {}
    static constexpr bool has(Fault) { return false; }
};

class SomeFaults {
public:
    explicit SomeFaults(FaultSet faults) : faults_(faults) {}
    bool has(Fault fault) const { return faults_.has(fault); }

private:
    FaultSet faults_;
};

/// Rays that go through the textbook index carry faults, all others none.
template <class Index>
using FaultsOf = std::conditional_t<std::is_same_v<Index, Textbook>, SomeFaults, NoFaults>;

/// The first two numbers of a generator seeded by the pixel's number, whatever the pass: neighbours have
/// nearly the same, and each sample repeats the last. S. K. Park, K. W. Miller 1988, "Random Number
/// Generators: Good Ones Are Hard to Find", CACM 31(10).
Vec2 badlySeeded(const SampleAddress&, int width, std::uint32_t node, SamplePurpose);

}
