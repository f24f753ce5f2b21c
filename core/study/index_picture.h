#pragma once
// The index over the scene as boxes in space: level by level, or as a ray goes through it.

#include <array>
#include <vector>

#include "core/geometry/traversal_log.h"
#include "core/scene/world.h"

namespace eyeray {

/// A box as it stands in the world. Corner i has the upper x if bit 0 of i is set, the upper y if bit 1, the
/// upper z if bit 2; of a mesh's box these are axes of the mesh.
struct SpaceBox {
    enum class Role : std::uint8_t { TopLevel, Mesh, Met, Missed, Tested } role = Role::TopLevel;
    std::array<Vec3, 8> corners; // relative to the World's origin
};

/// What there is to draw of an index.
struct IndexPicture {
    std::vector<SpaceBox> boxes;
    std::vector<std::array<Vec3, 3>> triangles; // tested
    std::size_t leftOut = 0;                    // boxes and triangles beyond kMostIndexBoxes of each
};

/// More boxes at once show nobody anything: the rest, the smallest, is left out.
inline constexpr std::size_t kMostIndexBoxes = 600;

/// Levels of boxes: the box around all is level 0, and below a leaf of the tree over the instances comes the
/// tree of its mesh. 0 if there is no tree.
int levelsOf(const World&);

/// The boxes of one level: TopLevel those of the tree over the instances, Mesh those of their meshes.
IndexPicture boxesOfLevel(const World&, int level);

/// What a log holds: boxes Met and Missed, the triangles tested, and of shapes tested the box. Infinite
/// planes have none.
IndexPicture pictureOf(const World&, const TraversalLog&);

}
