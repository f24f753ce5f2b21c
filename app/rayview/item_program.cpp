#include "app/rayview/item_program.h"

#include <string>

namespace eyeray {
namespace {

constexpr const char* kVertexShader = R"(#version 330 core
uniform mat4 toClip;
uniform mat4 toWorld;
uniform mat3 normalToWorld;
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 cornerNormal;
layout(location = 2) in vec2 cornerUv;
layout(location = 3) in vec3 cornerColor;
out vec3 position, normal, vertexColor;
out vec2 uv;
void main() {
    position = (toWorld * vec4(corner, 1.0)).xyz;
    normal = normalToWorld * cornerNormal;
    uv = cornerUv;
    vertexColor = cornerColor;
    gl_Position = toClip * vec4(corner, 1.0);
}
)";

constexpr const char* kFragmentPrelude = R"(#version 330 core
uniform vec3 eye;
uniform int textureKind;
uniform sampler2D picture;
uniform vec3 even, odd;
uniform vec3 uvRow0, uvRow1;
uniform int flatTriangles;
uniform int smoothChecker;
in vec3 position, normal, vertexColor;
in vec2 uv;

vec3 viewer() { return normalize(eye - position); }

vec3 facingNormal() {
    vec3 geometric = normalize(cross(dFdx(position), dFdy(position)));
    if (dot(geometric, viewer()) < 0.0) geometric = -geometric;
    if (flatTriangles != 0) return geometric;
    vec3 n = normalize(normal);
    if (!gl_FrontFacing) n = -n;
    return dot(n, viewer()) > 0.0 ? n : geometric;
}

vec3 linear(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), c));
}

// Share of a box of this width that lies in odd unit intervals, per axis: the integral of a square wave.
vec2 oddShare(vec2 p, vec2 width) {
    vec2 lo = p - 0.5 * width, hi = p + 0.5 * width;
    vec2 below = floor(lo * 0.5) + max(fract(lo * 0.5) * 2.0 - 1.0, 0.0);
    vec2 above = floor(hi * 0.5) + max(fract(hi * 0.5) * 2.0 - 1.0, 0.0);
    return clamp((above - below) / width, 0.0, 1.0);
}

vec3 textureColor() {
    vec2 p = vec2(dot(uvRow0, vec3(uv, 1.0)), dot(uvRow1, vec3(uv, 1.0)));
    if (textureKind == 1) {
        if (smoothChecker == 0) return vertexColor * (mod(floor(p.x) + floor(p.y), 2.0) == 0.0 ? even : odd);
        vec2 share = oddShare(p, max(fwidth(p), vec2(1e-5)));
        return vertexColor * mix(even, odd, share.x + share.y - 2.0 * share.x * share.y);
    }
    if (textureKind == 2) return vertexColor * linear(texture(picture, p).rgb);
    return vertexColor;
}
)";

}

ItemProgram::ItemProgram(const Gl& gl, const char* shading)
    : gl_(gl), program_(gl, kVertexShader, (std::string(kFragmentPrelude) + shading).c_str()) {}

void ItemProgram::begin(const Projection& projection) {
    clip_ = projection.clip();
    gl_.disable(GL_SCISSOR_TEST);
    gl_.disable(GL_STENCIL_TEST);
    gl_.disable(GL_FRAMEBUFFER_SRGB);
    gl_.disable(GL_BLEND);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depthFunc(GL_LESS);
    gl_.depthMask(GL_TRUE);
    gl_.colorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.polygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.activeTexture(GL_TEXTURE0);
    gl_.bindSampler(0, 0);
    program_.use();
    set("eye", Vec3(projection.eye()));
    set("picture", 0);
}

void ItemProgram::draw(const SceneItem& item) {
    const glm::mat4 toClip(clip_ * item.toWorld), toWorld(item.toWorld);
    const Mat3 normals(glm::inverse(glm::transpose(DMat3(item.toWorld))));
    gl_.uniformMatrix4fv(program_.uniform("toClip"), 1, GL_FALSE, &toClip[0][0]);
    gl_.uniformMatrix4fv(program_.uniform("toWorld"), 1, GL_FALSE, &toWorld[0][0]);
    gl_.uniformMatrix3fv(program_.uniform("normalToWorld"), 1, GL_FALSE, &normals[0][0]);
    set("flatTriangles", item.flat ? 1 : 0);
    setTexture(item.texture);
    const bool mirrored = glm::determinant(DMat3(item.toWorld)) < 0;
    gl_.frontFace(mirrored ? GL_CW : GL_CCW);
    item.oneSided ? gl_.enable(GL_CULL_FACE) : gl_.disable(GL_CULL_FACE);
    item.mesh->draw();
}

void ItemProgram::setTexture(const ItemTexture& texture) const {
    set("textureKind", static_cast<int>(texture.kind));
    if (texture.kind == ItemTexture::Kind::None) return;
    set("even", texture.even);
    set("odd", texture.odd);
    set("uvRow0", Vec3(texture.row0, texture.offset.x));
    set("uvRow1", Vec3(texture.row1, texture.offset.y));
    if (texture.image) gl_.bindTexture(GL_TEXTURE_2D, texture.image->name());
}

void ItemProgram::set(const char* name, const std::vector<Vec4>& values) const {
    if (!values.empty())
        gl_.uniform4fv(program_.uniform(name), static_cast<GLsizei>(values.size()), &values.front().x);
}

}
