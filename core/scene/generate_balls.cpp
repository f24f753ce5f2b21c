#include <algorithm>

#include "core/base/errors.h"
#include "core/base/sampling.h"
#include "core/scene/generate.h"

namespace eyeray {

namespace {

/// Directions to the nine balls on a ball, around +y: the neighbours that a ball in a closest packing has
/// beside and above itself.
std::array<DVec3, 9> flakeDirections() {
    std::array<DVec3, 9> result;
    for (int i = 0; i < 6; ++i) {
        const double angle = i * kPiD / 3;
        result[i] = {std::cos(angle), 0, std::sin(angle)};
    }
    const double rise = std::sqrt(2.0 / 3), reach = std::sqrt(1.0 / 3);
    for (int i = 0; i < 3; ++i) {
        const double angle = kPiD / 6 + i * 2 * kPiD / 3;
        result[6 + i] = {reach * std::cos(angle), rise, reach * std::sin(angle)};
    }
    return result;
}

}

std::vector<Ball> makeSpiral(const SpiralRule& rule) {
    ENSURE(rule.count > 0 && rule.radius > 0 && rule.spread > 0);
    const double goldenAngle = kPiD * (3 - std::sqrt(5.0));
    constexpr double kNearest = 1.54; // no two points of the unit spiral √k are nearer; measured for 200,000
    const double scale = rule.spread / std::sqrt(static_cast<double>(rule.count));
    const double largest = std::min(rule.radius, kNearest / 2 * scale);

    std::vector<Ball> balls;
    balls.reserve(static_cast<std::size_t>(rule.count));
    for (int k = 0; k < rule.count; ++k) {
        const auto hash = hashCombine(rule.seed, static_cast<std::uint32_t>(k));
        const double radius = largest * (0.4 + 0.6 * static_cast<double>(toUnitFloat(hash)));
        const double angle = k * goldenAngle, distance = scale * std::sqrt(k + 0.5);
        balls.push_back({{distance * std::cos(angle), radius, distance * std::sin(angle)}, radius, k});
    }
    return balls;
}

std::vector<Ball> makeFlake(const FlakeRule& rule) {
    ENSURE(rule.radius > 0 && rule.levels >= 0);
    const auto directions = flakeDirections();
    std::vector<Ball> balls{{DVec3(0), rule.radius, 0}};
    std::vector<DVec3> axes{{0, 1, 0}};
    for (std::size_t first = 0, level = 0; level < static_cast<std::size_t>(rule.levels); ++level) {
        const std::size_t end = balls.size();
        for (; first < end; ++first) {
            const Ball parent = balls[first];
            const DVec3 axis = axes[first];
            const Frame frame = Frame::around(Vec3(axis));
            const DVec3 tangent =
                safeNormalize(DVec3(frame.tangent) - glm::dot(DVec3(frame.tangent), axis) * axis);
            const DVec3 bitangent = glm::cross(axis, tangent);
            const double radius = parent.radius / 3;
            for (const DVec3& d : directions) {
                const DVec3 direction = d.x * tangent + d.y * axis + d.z * bitangent;
                balls.push_back(
                    {parent.center + (parent.radius + radius) * direction, radius, parent.turn + 1});
                axes.push_back(direction);
            }
        }
    }
    return balls;
}

}
