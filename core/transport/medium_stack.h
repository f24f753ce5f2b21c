#pragma once
// Which solids a ray is inside of.

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace eyeray {

/// Instances whose inside a ray is in, by their rank, so that it does not matter in which order they were
/// entered. Where solids overlap the one of the highest rank is what is there. Beyond kCapacity solids in one
/// place further ones are not entered.
class MediumStack {
public:
    static constexpr std::uint32_t kVacuum = 0xffffffff;

    /// What the ray runs in.
    std::uint32_t top() const { return size_ > 0 ? instanceOf(ranked_[size_ - 1]) : kVacuum; }
    bool contains(std::uint32_t instance) const {
        return std::any_of(begin(), end(),
                           [=](std::uint64_t entry) { return instanceOf(entry) == instance; });
    }
    /// `rank` is WorldObject's.
    MediumStack entered(std::uint32_t instance, std::uint32_t rank) const {
        MediumStack result = *this;
        if (size_ == kCapacity || contains(instance)) return result;
        const std::uint64_t entry = static_cast<std::uint64_t>(rank) << 32U | instance;
        const auto place = std::upper_bound(begin(), end(), entry) - begin();
        std::copy_backward(begin() + place, end(), result.ranked_.begin() + size_ + 1);
        result.ranked_[static_cast<std::size_t>(place)] = entry;
        ++result.size_;
        return result;
    }
    MediumStack left(std::uint32_t instance) const {
        MediumStack result = *this;
        const auto last = std::remove_if(result.ranked_.begin(), result.ranked_.begin() + size_,
                                         [=](std::uint64_t entry) { return instanceOf(entry) == instance; });
        result.size_ = static_cast<std::uint8_t>(last - result.ranked_.begin());
        return result;
    }

    friend bool operator==(const MediumStack& a, const MediumStack& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }
    std::size_t hash() const {
        return std::accumulate(begin(), end(), std::size_t{0}, [](std::size_t sum, std::uint64_t entry) {
            return (sum ^ entry) * 0x9e3779b97f4a7c15U;
        });
    }

private:
    static constexpr std::uint8_t kCapacity = 6;

    static std::uint32_t instanceOf(std::uint64_t entry) { return static_cast<std::uint32_t>(entry); }
    const std::uint64_t* begin() const { return ranked_.data(); }
    const std::uint64_t* end() const { return begin() + size_; }

    std::array<std::uint64_t, kCapacity> ranked_{}; // rank and instance, ascending
    std::uint8_t size_ = 0;
};

}
