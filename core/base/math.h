#pragma once
// Vector types and the few constants and helpers that every layer shares.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace eyeray {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using DVec2 = glm::dvec2;
using DVec3 = glm::dvec3;
using DVec4 = glm::dvec4;
using Mat3 = glm::mat3;
using DMat3 = glm::dmat3;
using DMat4 = glm::dmat4;
using Color = glm::vec3; // linear Rec. 709: reflectance, radiance or irradiance, as the name says

inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kPi = 3.14159265358979323846F;
inline constexpr double kPiD = 3.14159265358979323846;

/// Bound on the relative error of n chained float operations.
/// Higham 2002, "Accuracy and Stability of Numerical Algorithms", section 3.1.
constexpr float gammaBound(int n) {
    constexpr float u = std::numeric_limits<float>::epsilon() * 0.5F;
    return static_cast<float>(n) * u / (1.0F - static_cast<float>(n) * u);
}

/// The next float above x, which is ≥ 0 and finite.
inline float nextAbove(float x) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + 1); }

/// The next float after a finite x towards ±∞.
inline float nextTowards(float x, bool up) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    if (x == 0) return up ? 0x1p-126F : -0x1p-126F; // a smaller one would be flushed to zero
    return std::bit_cast<float>((x > 0) == up ? bits + 1 : bits - 1);
}

inline bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool isFinite(const DVec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline float maxComponent(const Vec3& v) { return std::fmax(v.x, std::fmax(v.y, v.z)); }
inline float minComponent(const Vec3& v) { return std::fmin(v.x, std::fmin(v.y, v.z)); }
inline bool isBlack(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

/// Luminance of linear Rec. 709.
inline float luminance(const Color& c) { return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z; }
inline double luminance(const DVec3& c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; }

constexpr double radians(double degrees) { return degrees * (kPiD / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / kPiD); }

/// Point transformed by an affine matrix.
inline DVec3 transformPoint(const DMat4& m, const DVec3& p) { return DVec3(m * DVec4(p, 1.0)); }

/// Direction transformed by an affine matrix; not renormalised.
inline DVec3 transformVector(const DMat4& m, const DVec3& v) { return DVec3(m * DVec4(v, 0.0)); }

/// v / |v| computed without underflow or overflow of |v|²; (0, 0, 0) for a zero or non-finite vector.
inline DVec3 safeNormalize(const DVec3& v) {
    const double square = glm::dot(v, v);
    if (square > 1e-280 && square < 1e280) return v * (1 / std::sqrt(square));
    const double scale = std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
    if (!(scale > 0) || !std::isfinite(scale)) return DVec3(0);
    const DVec3 scaled = v / scale;
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

/// Orthonormal frame around a unit normal.
/// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1).
struct Frame {
    Vec3 tangent, bitangent, normal;

    static Frame around(const Vec3& n) {
        const float sign = std::copysign(1.0F, n.z);
        const float a = -1.0F / (sign + n.z);
        const float b = n.x * n.y * a;
        return {Vec3(1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x), Vec3(b, sign + n.y * n.y * a, -n.y),
                n};
    }
};

}
