#pragma once
// What `eyeray inspect` has found, and the forms that it is told in.

#include <string>

#include "app/document/document.h"
#include "core/study/ledger.h"
#include "core/study/ray_traversal.h"

namespace eyeray {

/// One sample of one pixel.
struct Inspected {
    std::string reference; // of the scene
    std::shared_ptr<const World> world;
    RenderSettings settings;
    PixelPosition pixel;
    int sample = 0;
    Color film; // what the renderer puts into the film for it
    Retrace trace;
    Ledger ledger;
    std::vector<TraversalCounts> traversal; // of each ray

    /// "pixel (320, 240) of homage, 640×480, sample 0"
    std::string title() const;
    /// A position on record in the scene's coordinates.
    DVec3 inScene(const Vec3& position) const { return DVec3(position) + world->origin; }
};

/// The tree, indented, and beneath it the sum.
std::string textOf(const Inspected&);

/// Everything, as docs of the command line promise: numbers have the shortest digits that read back as the
/// same float; what is infinite is null.
std::string jsonOf(const Inspected&);

/// A heading, then a line for each ray.
std::string csvOf(const Inspected&);

}
