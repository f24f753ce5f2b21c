#include "app/rayview/image_plane.h"

#include <algorithm>

#include <fmt/format.h>

namespace eyeray {
namespace {

constexpr double kNearestShare = 0.4, kFarthestShare = 0.6; // of the way to the nearest thing

constexpr const char* kVertexShader = R"(#version 330 core
uniform vec4 corners[4];
out vec2 uv;
void main() {
    int corner = gl_VertexID < 3 ? gl_VertexID : (gl_VertexID == 3 ? 0 : gl_VertexID - 2);
    uv = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner >= 2 ? 1.0 : 0.0);
    gl_Position = corners[corner];
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
uniform sampler2D picture;
uniform vec2 cells;
in vec2 uv;
out vec4 color;
void main() {
    vec2 p = uv * cells, width = max(fwidth(p), vec2(1e-6));
    vec2 line = clamp(1.0 - abs(fract(p - 0.5) - 0.5) / width, 0.0, 1.0) * smoothstep(0.5, 0.1, width);
    vec3 shown = texture(picture, uv).rgb;
    float luma = dot(shown, vec3(0.3, 0.6, 0.1));
    color = vec4(mix(shown, vec3(luma > 0.5 ? 0.0 : 1.0), 0.35 * max(line.x, line.y)), 0.93);
}
)";

}

DVec3 ImagePlane::point(const DVec2& pixel, int width, int height) const {
    const DVec2 share = pixel / DVec2(width, height);
    return corners[0] + share.x * (corners[1] - corners[0]) + share.y * (corners[3] - corners[0]);
}

std::string ImagePlane::cornerText(int corner) const {
    const bool right = corner == 1 || corner == 2, top = corner < 2;
    return fmt::format("({}{:.2f}, {}{:.2f}, −1)", right ? "" : "−", half.x, top ? "" : "−", half.y);
}

ImagePlane imagePlaneOf(const Camera& camera, const DVec3& origin, double aspect, double nearest) {
    const CameraAxes axes = axesOf(camera);
    ImagePlane plane;
    plane.eye = camera.eye - origin;
    plane.half = imagePlaneHalfExtents(camera.verticalFov, aspect);
    constexpr double kLeast = 1e-6; // metres: an eye may stand on its target
    const double ahead = std::max(nearest, kLeast);
    plane.scale = std::clamp(1.0, kNearestShare * ahead, kFarthestShare * ahead);
    const DVec3 middle = plane.eye - plane.scale * axes.backward;
    const DVec3 right = plane.scale * plane.half.x * axes.right, up = plane.scale * plane.half.y * axes.up;
    plane.corners = {middle - right + up, middle + right + up, middle + right - up, middle - right - up};
    return plane;
}

int gridStep(int pixels, double lengthOnScreen, double leastApart) {
    int step = 1;
    while (step < pixels && lengthOnScreen * step < leastApart * pixels) step *= 2;
    return step;
}

PictureQuad::PictureQuad(const Gl& gl)
    : gl_(gl), program_(gl, kVertexShader, kFragmentShader),
      noVertices_(gl.genVertexArrays, gl.deleteVertexArrays) {}

void PictureQuad::draw(const GlTexture& picture, const ImagePlane& plane, const Projection& projection,
                       const DVec2& cells) const {
    std::array<Vec4, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = Vec4(projection.clip() * DVec4(plane.corners[i], 1));
    gl_.disable(GL_CULL_FACE);
    gl_.disable(GL_SCISSOR_TEST);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthFunc(GL_LESS);
    gl_.depthMask(GL_TRUE);
    gl_.enable(GL_BLEND);
    gl_.blendEquation(GL_FUNC_ADD);
    gl_.blendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.polygonMode(GL_FRONT_AND_BACK, GL_FILL);
    program_.use();
    gl_.uniform4fv(program_.uniform("corners"), 4, &corners[0].x);
    gl_.uniform1i(program_.uniform("picture"), 0);
    gl_.uniform2f(program_.uniform("cells"), static_cast<float>(cells.x), static_cast<float>(cells.y));
    gl_.activeTexture(GL_TEXTURE0);
    gl_.bindSampler(0, 0);
    gl_.bindTexture(GL_TEXTURE_2D, picture.name());
    gl_.bindVertexArray(noVertices_.name());
    gl_.drawArrays(GL_TRIANGLES, 0, 6);
    gl_.disable(GL_BLEND);
}

}
