#pragma once
// Which solids a ray is inside of.

#include <algorithm>
#include <array>
#include <cstdint>

namespace eyeray {

/// Instances whose inside a ray is in, outermost first. The last one entered rules; leaving one removes it
/// wherever it stands, so overlapping solids do no harm. Beyond kCapacity nested solids further ones are not
/// entered.
class MediumStack {
public:
    static constexpr std::uint32_t kVacuum = 0xffffffff;

    std::uint32_t top() const { return size_ > 0 ? instances_[size_ - 1] : kVacuum; }
    bool contains(std::uint32_t instance) const {
        return std::find(instances_.begin(), instances_.begin() + size_, instance) !=
               instances_.begin() + size_;
    }
    MediumStack entered(std::uint32_t instance) const {
        MediumStack result = *this;
        if (size_ < kCapacity && !contains(instance)) result.instances_[result.size_++] = instance;
        return result;
    }
    MediumStack left(std::uint32_t instance) const {
        MediumStack result = *this;
        const auto end = result.instances_.begin() + size_;
        result.size_ = static_cast<std::uint8_t>(std::remove(result.instances_.begin(), end, instance) -
                                                 result.instances_.begin());
        return result;
    }

private:
    static constexpr std::uint8_t kCapacity = 6;
    std::array<std::uint32_t, kCapacity> instances_{};
    std::uint8_t size_ = 0;
};

}
