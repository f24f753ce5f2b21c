#include <algorithm>
#include <numeric>

#include "core/base/errors.h"
#include "core/base/sampling.h"
#include "core/scene/generate.h"

namespace eyeray {

namespace {

/// Indices of rows × columns quads over (rows + 1) × (columns + 1) vertices, split along the same diagonal;
/// counter-clockwise when columns run along a and rows along b, seen from a × b.
void addGridTriangles(TriangleMesh& mesh, std::uint32_t rows, std::uint32_t columns) {
    mesh.triangles.reserve(std::size_t{2} * rows * columns);
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t corner = row * (columns + 1) + column, next = corner + columns + 1;
            mesh.triangles.push_back({corner, corner + 1, next + 1});
            mesh.triangles.push_back({corner, next + 1, next});
        }
}

/// Value in about [−1, 1], 0 at whole coordinates, with continuous second derivatives.
double gradientNoise(double x, double z, std::uint32_t seed) {
    const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
    const double cellX = std::floor(x), cellZ = std::floor(z);
    const auto corner = [&](int dx, int dz) {
        const auto ix = static_cast<std::uint32_t>(static_cast<std::int64_t>(cellX) + dx);
        const auto iz = static_cast<std::uint32_t>(static_cast<std::int64_t>(cellZ) + dz);
        const std::uint32_t hash = hashCombine(hashCombine(seed, ix), iz);
        const double angle = 2 * kPiD * static_cast<double>(toUnitFloat(hash));
        return std::cos(angle) * (x - cellX - dx) + std::sin(angle) * (z - cellZ - dz);
    };
    const double u = fade(x - cellX), v = fade(z - cellZ);
    const double near = std::lerp(corner(0, 0), corner(1, 0), u);
    const double far = std::lerp(corner(0, 1), corner(1, 1), u);
    return std::lerp(near, far, v);
}

/// Hills in about [−1, 1] over the unit square; each octave is twice as fine and less than half as high, so
/// that slopes get gentler as they get shorter.
double hills(double x, double z, std::uint32_t seed) {
    constexpr int kOctaves = 7;
    constexpr double kHillsAcross = 3, kRoughness = 0.42;
    double sum = 0, amplitude = 1, frequency = kHillsAcross;
    for (int octave = 0; octave < kOctaves; ++octave) {
        sum += amplitude * gradientNoise(x * frequency, z * frequency,
                                         hashCombine(seed, static_cast<std::uint32_t>(octave)));
        amplitude *= kRoughness;
        frequency *= 2;
    }
    return sum;
}

}

TriangleMesh makeTerrain(const TerrainRule& rule) {
    ENSURE(rule.size > 0 && rule.height >= 0 && rule.triangles > 0);
    const auto quads =
        static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(rule.triangles) / 2)));
    const std::uint32_t side = quads + 1;
    const double step = 1.0 / quads;

    std::vector<double> heights(std::size_t{side} * side);
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column)
            heights[std::size_t{row} * side + column] = hills(column * step, row * step, rule.seed);
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    const double base = *lowest, scale = *highest > base ? rule.height / (*highest - base) : 0;
    const auto heightAt = [&](std::uint32_t row, std::uint32_t column) {
        return (heights[std::size_t{row} * side + column] - base) * scale;
    };

    TriangleMesh mesh;
    for (std::uint32_t row = 0; row < side; ++row)
        for (std::uint32_t column = 0; column < side; ++column) {
            const double u = column * step, v = row * step;
            const std::uint32_t left = column > 0 ? column - 1 : 0, right = std::min(column + 1, quads);
            const std::uint32_t back = row > 0 ? row - 1 : 0, front = std::min(row + 1, quads);
            const double slopeX =
                (heightAt(row, right) - heightAt(row, left)) / ((right - left) * step * rule.size);
            const double slopeZ =
                (heightAt(front, column) - heightAt(back, column)) / ((front - back) * step * rule.size);
            mesh.positions.emplace_back((u - 0.5) * rule.size, heightAt(row, column), (v - 0.5) * rule.size);
            mesh.normals.emplace_back(safeNormalize(DVec3(-slopeX, 1, -slopeZ)));
            mesh.uvs[0].emplace_back(u, v);
        }
    addGridTriangles(mesh, quads, quads);
    // x runs with the columns and z with the rows, so the grid faces x × z = −y: turn it over.
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
    return mesh;
}

TriangleMesh makeKnot(const KnotRule& rule) {
    ENSURE(rule.radius > 0 && rule.tube > 0 && rule.triangles > 0);
    ENSURE(rule.p > 0 && rule.q > 0 && std::gcd(rule.p, rule.q) == 1);
    // The curve lies on a torus of radii 2/3 and 1/3; the torus' normal is always across it, so it makes a
    // frame that closes by itself.
    const auto frameAt = [&](double t) {
        const double a = rule.p * t, b = rule.q * t, minor = rule.radius / 3, major = 2 * minor;
        const double reach = major + minor * std::cos(b);
        const DVec3 outward(std::cos(a), 0, std::sin(a)), along(-std::sin(a), 0, std::cos(a));
        const DVec3 center = reach * outward + DVec3(0, minor * std::sin(b), 0);
        const DVec3 normal = std::cos(b) * outward + DVec3(0, std::sin(b), 0);
        const DVec3 turn = -std::sin(b) * outward + DVec3(0, std::cos(b), 0);
        const DVec3 tangent = safeNormalize(rule.p * reach * along + rule.q * minor * turn);
        struct Ring {
            DVec3 center, normal, binormal;
        };
        return Ring{center, normal, glm::cross(tangent, normal)};
    };

    const double length = 2 * kPiD * rule.radius * std::hypot(2.0 * rule.p / 3, rule.q / 3.0);
    const double quads = static_cast<double>(rule.triangles) / 2;
    const double ideal = std::sqrt(quads * length / (2 * kPiD * rule.tube)); // nearly square quads
    const auto rings = static_cast<std::uint32_t>(std::max(ideal, 8.0 * std::max(rule.p, rule.q)));
    const auto sides = static_cast<std::uint32_t>(std::max(std::ceil(quads / rings), 3.0));

    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rings; ++i) {
        const auto ring = frameAt(2 * kPiD * (i % rings) / rings); // the last ring is the first, bit for bit
        for (std::uint32_t k = 0; k <= sides; ++k) {
            const double angle = 2 * kPiD * (k % sides) / sides;
            const DVec3 normal = std::cos(angle) * ring.normal + std::sin(angle) * ring.binormal;
            mesh.positions.emplace_back(ring.center + rule.tube * normal);
            mesh.normals.emplace_back(normal);
            mesh.uvs[0].emplace_back(static_cast<double>(i) / rings, static_cast<double>(k) / sides);
        }
    }
    addGridTriangles(mesh, rings, sides);
    return mesh;
}

}
