#pragma once
// Who belongs to whom in a record: which rays, lamps and untraced rays start where a ray ends.

#include <span>
#include <vector>

#include "core/transport/recorder.h"

namespace eyeray {

/// Indices in groups, each group in the order of the whole.
class Groups {
public:
    /// Item i goes to group groupOf[i]; those of a negative group are in none.
    Groups(std::size_t groups, std::span<const int> groupOf);

    std::span<const int> operator[](int group) const {
        const auto g = static_cast<std::size_t>(group);
        return std::span(items_).subspan(begins_[g], begins_[g + 1] - begins_[g]);
    }

private:
    std::vector<std::size_t> begins_;
    std::vector<int> items_;
};

/// For each ray of a record, by its index: what starts at its hit, in order of tracing.
struct Family {
    explicit Family(const SampleRecord&);

    Groups nextRays; // reflections and refractions
    Groups shadowRays;
    Groups lamps;    // indices into SampleRecord::lamps
    Groups untraced; // indices into SampleRecord::untraced
};

}
