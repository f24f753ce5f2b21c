#include "core/study/lab_kit.h"

namespace eyeray::lab {

TriangleMesh ballMesh(int rows) {
    TriangleMesh mesh;
    const int columns = 2 * rows;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double theta = kPiD * row / rows, phi = 2 * kPiD * column / columns;
            const DVec3 p(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            mesh.positions.emplace_back(p);
            mesh.normals.emplace_back(p);
        }
    const auto vertex = [&](int row, int column) {
        return static_cast<std::uint32_t>(row * columns + column % columns);
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = vertex(row, column), b = vertex(row, column + 1),
                                c = vertex(row + 1, column), d = vertex(row + 1, column + 1);
            if (row > 0) mesh.triangles.push_back({a, b, d});
            if (row + 1 < rows) mesh.triangles.push_back({a, d, c});
        }
    return mesh;
}

}
