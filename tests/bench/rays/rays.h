#pragma once
// Meshes and the rays that are sent through them, the same for every tracer.

#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/accel.h"

namespace eyeray::bench {

struct TestMesh {
    std::string name;
    std::shared_ptr<const TriangleMesh> mesh;
    DVec3 eye, target;
};

/// A box of few triangles, a knot of 100,000, a terrain of a million, and 200,000 random slivers.
std::vector<TestMesh> testMeshes();

struct RayKindSet {
    std::string_view name;
    bool anyHit = false; // what is asked of its rays
    std::vector<Ray> rays;
};

/// Eye rays of a picture, row by row in blocks of 8 by 8, and from what they hit: shadow rays to a lamp,
/// mirrored rays and rays in random directions over the surface.
std::vector<RayKindSet> raysFor(const TestMesh&);

}
