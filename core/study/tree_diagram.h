#pragma once
// The diagram of a sample's rays: what stands in its nodes, and where. The window and the SVG draw the same.

#include <array>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/transport/integrator.h"

namespace eyeray {

/// What a view of the tree leaves out; with a node goes all that hangs on it.
struct TreeFilter {
    std::array<bool, kRayKinds> kinds{true, true, true, true, true};
    bool untraced = true;       // rays that were not traced, with the reason
    float leastWeight = 0;      // of the largest channel
    std::vector<int> collapsed; // rays whose children are hidden, sorted

    bool shows(const RayRecord&) const;
    bool shows(const UntracedRay&) const;
    bool isCollapsed(int ray) const;
    friend bool operator==(const TreeFilter&, const TreeFilter&) = default;
};

/// A box, with its corner of least x and y; lengths are in heights of a letter.
struct DiagramNode {
    int parent = -1; // in the diagram
    int ray = -1;    // on record; of a ray that was not traced: at whose hit
    RayKind kind = RayKind::Eye;
    bool traced = true;
    bool faint = false;        // blocked, or not traced
    std::string title, detail; // lines; detail may be empty
    std::string edge;          // weight, as text on the edge to it
    Color radiance{0};         // what the ray brings
    int hidden = 0;            // rays and untraced rays that hang on it and are left out
    float x = 0, y = 0, width = 0, height = 0;
};

struct TreeDiagram {
    std::vector<DiagramNode> nodes; // parents first
    float width = 0, height = 0;
};

/// Time flows to the right: the eye ray stands at the left.
TreeDiagram diagramOf(const SampleRecord&, const Scene&, const TreeFilter&);

/// The four points of the cubic Bézier curve from a node's parent to it.
std::array<Vec2, 4> edgeCurve(const TreeDiagram&, const DiagramNode&);

/// Where the base line of the edge's text ends: at the node, on the side that the curve does not come from.
Vec2 edgeLabel(const TreeDiagram&, const DiagramNode&);

/// Point of the cubic Bézier curve at s from 0 to 1.
Vec2 pointOf(const std::array<Vec2, 4>& curve, float s);

}
