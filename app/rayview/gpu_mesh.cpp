#include "app/rayview/gpu_mesh.h"

#include <bit>
#include <cstddef>

namespace eyeray {
namespace {

template <class T>
void upload(const Gl& gl, GLenum target, const std::vector<T>& values) {
    gl.bufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

}

GpuMesh::GpuMesh(const Gl& gl, const SurfaceMesh& mesh)
    : gl_(gl), vertexArray_(gl.genVertexArrays, gl.deleteVertexArrays),
      vertices_(gl.genBuffers, gl.deleteBuffers), indices_(gl.genBuffers, gl.deleteBuffers),
      count_(static_cast<GLsizei>(3 * mesh.triangles.size())) {
    gl.bindVertexArray(vertexArray_.name());
    gl.bindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    upload(gl, GL_ARRAY_BUFFER, mesh.vertices);
    upload(gl, GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    const auto attribute = [&](GLuint location, GLint floats, std::size_t offset) {
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex),
                               std::bit_cast<const void*>(offset));
    };
    attribute(0, 3, offsetof(SurfaceVertex, position));
    attribute(1, 3, offsetof(SurfaceVertex, normal));
    attribute(2, 2, offsetof(SurfaceVertex, uv));
    attribute(3, 3, offsetof(SurfaceVertex, color));
    gl.bindVertexArray(0);
}

void GpuMesh::draw() const {
    gl_.bindVertexArray(vertexArray_.name());
    gl_.drawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

}
