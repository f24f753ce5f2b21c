#pragma once
// Embree as a peer: the same mesh, the same rays, in the same process.

#include <memory>
#include <vector>

#include "core/geometry/mesh.h"
#include "core/geometry/ray.h"
#include "tests/bench/rays/ray_columns.h"

namespace eyeray::bench {

class EmbreeScene {
public:
    EmbreeScene(const TriangleMesh&, bool robust);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// t of the closest hit, infinite if there is none.
    float closest(const Ray&) const;
    bool any(const Ray&) const;
    /// The same of many rays, sixteen at a time and declared as coherent: t, or 1 and 0.
    void closest(const RayColumns&, std::vector<float>& answers) const;
    void any(const RayColumns&, std::vector<float>& answers) const;
    /// Of the last build.
    double buildSeconds() const { return buildSeconds_; }
    /// Memory that Embree took for the last build.
    std::size_t bytes() const;

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    double buildSeconds_ = 0;
};

}
