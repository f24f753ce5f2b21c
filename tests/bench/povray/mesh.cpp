// eyeray_pov_mesh > knot.inc: the mesh of mirror.gltf and glass.gltf as POV-Ray's mesh2 without its closing
// brace.

#include <fmt/format.h>

#include "core/scene/generate.h"

namespace {

template <class Items, class Write>
void printList(const char* name, const Items& items, const Write& write) {
    fmt::print("{} {{ {}", name, items.size());
    for (const auto& item : items) fmt::print(",\n{}", write(item));
    fmt::print(" }}\n");
}

}

int main() {
    const eyeray::TriangleMesh knot =
        eyeray::makeKnot({.p = 2, .q = 3, .radius = 1, .tube = 0.27, .triangles = 70'000});
    const auto vector = [](const eyeray::Vec3& v) { return fmt::format("<{}, {}, {}>", v.x, v.y, v.z); };
    const auto face = [](const auto& corners) {
        return fmt::format("<{}, {}, {}>", corners[0], corners[1], corners[2]);
    };
    fmt::print("mesh2 {{\n");
    printList("vertex_vectors", knot.positions, vector);
    printList("normal_vectors", knot.normals, vector);
    printList("face_indices", knot.triangles, face);
    return 0;
}
