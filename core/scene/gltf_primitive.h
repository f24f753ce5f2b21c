#pragma once
// One primitive of a mesh as triangles.

#include <optional>
#include <string>

#include "core/geometry/mesh.h"
#include "core/scene/gltf_import.h"

namespace eyeray {

/// The triangles of a primitive in file order; none, with a note, for points, lines, and what has no
/// positions. Triangles with a vertex that does not exist or is not finite are dropped, broken normals are
/// made from the triangles, broken texture coordinates and colours are set to 0, each with a note. Throws
/// InputError where accessors do not fit.
std::optional<TriangleMesh> importPrimitive(GltfImport&, const tinygltf::Primitive&,
                                            const std::string& where);

}
