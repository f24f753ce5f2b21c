#pragma once
// Roots as school teaches them.

#include <cmath>
#include <optional>

namespace eyeray::textbook {

template <class T>
struct RootsOf {
    T lower, upper;
};

/// (−b ∓ √(b² − 4ac)) / 2a for a > 0, or nothing where the discriminant is negative. F03: −b ∓ √… cancels in
/// the root that is small beside the other; F01: b² and 4ac cancel where the roots lie close together.
template <class T>
std::optional<RootsOf<T>> quadraticRoots(T a, T b, T c) {
    const T discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return {};
    const T root = std::sqrt(discriminant);
    return RootsOf<T>{(-b - root) / (2 * a), (-b + root) / (2 * a)};
}

}
