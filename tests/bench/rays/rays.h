#pragma once
// Meshes through which the same rays are sent by every tracer.

#include <string>
#include <vector>

#include "core/scene/camera.h"
#include "core/study/ray_bench.h"

namespace eyeray::bench {

struct TestMesh {
    std::string name;
    std::shared_ptr<const TriangleMesh> mesh;
    DVec3 eye, target;
};

/// A box of few triangles, a knot of 100,000, a terrain of a million, and 200,000 random slivers.
std::vector<TestMesh> testMeshes();

/// Rays of a picture of the mesh and from what they hit.
std::vector<RaySet> raysFor(const TestMesh&);

}
