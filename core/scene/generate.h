#pragma once
// Objects that Eyeray makes by rule when it loads a scene: large or regular things that need no file of their
// own. The same numbers give the same object everywhere.

#include <cstdint>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mesh.h"

namespace eyeray {

/// Square of hills around the origin, y up, heights from 0 to `height`.
struct TerrainRule {
    double size = 10, height = 1;     // metres
    std::int64_t triangles = 100'000; // at least
    std::uint32_t seed = 1;
};

/// Sum of octaves of gradient noise with unit normals and texture coordinates over [0, 1]².
/// Noise: K. Perlin 2002, "Improving Noise", SIGGRAPH. Sum: F. K. Musgrave in Ebert et al. 2003, "Texturing
/// and Modeling" 3rd ed., chapter 16.
TriangleMesh makeTerrain(const TerrainRule&);

/// Tube around a curve that winds p times around the y axis while it winds q times around a torus.
struct KnotRule {
    int p = 2, q = 3;                 // coprime
    double radius = 1, tube = 0.2;    // of the whole knot without its tube, and of the tube; metres
    std::int64_t triangles = 100'000; // at least
};

/// Closed mesh with unit normals; u runs along the tube and v around it, both once over [0, 1].
TriangleMesh makeKnot(const KnotRule&);

/// Where a ball lies, how large it is, and which in turn it is.
struct Ball {
    DVec3 center;
    double radius;
    int turn;
};

/// Balls on the plane y = 0, the k-th at the angle k · golden angle and the distance spread · √(k/count).
struct SpiralRule {
    int count = 1000;
    double radius = 0.1, spread = 5; // of the largest ball and of the whole spiral, metres
    std::uint32_t seed = 1;
};

/// The balls lie apart from each other: where `radius` is too large for `spread`, all of them are smaller.
/// Spiral: H. Vogel 1979, "A Better Way to Construct the Sunflower Head", Mathematical Biosciences 44.
std::vector<Ball> makeSpiral(const SpiralRule&);

/// A ball with nine balls of a third of its size on it, six around its equator and three above, each with
/// nine of its own, and so on; (9^(levels + 1) − 1)/8 balls. `turn` is the level.
/// E. Haines 1987, "A Proposal for Standard Graphics Environments", IEEE CG&A 7(11).
struct FlakeRule {
    double radius = 0.5; // metres
    int levels = 3;
};
std::vector<Ball> makeFlake(const FlakeRule&);

}
