#include "app/rayview/outside_painter.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr float kFadeRadii = 5; // infinite planes have faded out at this distance from the scene's middle

constexpr const char* kShading = R"(
uniform vec3 base, glow, shine;
uniform float glass, gloss, fadeRadius, pictureHeight, light;
uniform vec3 keyLight, backdropTop, backdropFoot;
out vec4 color;

vec3 coded(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c));
}

void main() {
    vec3 v = viewer(), n = facingNormal(), r = reflect(-v, n);
    float key = max(dot(n, keyLight), 0.0), sky = 0.5 + 0.5 * n.y;
    vec3 lit = base * textureColor() * (0.22 + 0.34 * sky + 0.55 * key);
    // a room to mirror: a bright ceiling above a dark floor
    lit += shine * mix(0.12, 0.85, smoothstep(-0.25, 0.55, r.y));
    lit += gloss * pow(max(dot(r, keyLight), 0.0), 48.0);
    // paler than it is, so that the rays before it stand out
    lit = mix(vec3(dot(lit, vec3(0.2126, 0.7152, 0.0722))), lit, 0.62) * light;
    float edge = pow(1.0 - max(dot(n, v), 0.0), 3.0);
    float alpha = mix(1.0, 0.16 + 0.55 * edge, glass);
    vec3 shown = coded(mix(lit, lit + 0.35 * edge, glass) + glow);
    if (fadeRadius > 0.0) {
        vec3 behind = mix(backdropFoot, backdropTop, gl_FragCoord.y / pictureHeight);
        shown = mix(shown, behind, smoothstep(0.25, 1.0, length(position) / fadeRadius));
    }
    color = vec4(shown, alpha);
}
)";

// One triangle over all of the picture.
constexpr const char* kBackdropVertices = R"(#version 330 core
out float height;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    height = 0.5 + 0.5 * corner.y;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr const char* kBackdropShading = R"(#version 330 core
uniform vec3 backdropTop, backdropFoot;
in float height;
out vec4 color;
void main() { color = vec4(mix(backdropFoot, backdropTop, height), 1.0); }
)";

/// What a person takes for the colour of a thing: of a mirror or glass it is not kd.
Color baseOf(const Surface& s) {
    return glm::min(s.diffuse + (s.transmits() ? s.refractable * 0.6F : Color(0)), Color(1));
}

Color shineOf(const Surface& s) { return glm::min(s.reflectivity, Color(1)); }

}

OutsidePainter::OutsidePainter(const Gl& gl)
    : gl_(gl), program_(gl, kShading), backdrop_(gl, kBackdropVertices, kBackdropShading),
      noVertices_(gl.genVertexArrays, gl.deleteVertexArrays) {}

void OutsidePainter::drawBackdrop(const Backdrop& backdrop) {
    constexpr GLfloat kFar = 1;
    gl_.depthMask(GL_TRUE);
    for (const GLenum off : {GL_SCISSOR_TEST, GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND}) gl_.disable(off);
    gl_.clearBufferfv(GL_DEPTH, 0, &kFar);
    gl_.polygonMode(GL_FRONT_AND_BACK, GL_FILL);
    backdrop_.use();
    const auto set = [&](const char* name, const Color& c) {
        gl_.uniform3f(backdrop_.uniform(name), c.r, c.g, c.b);
    };
    set("backdropTop", backdrop.top);
    set("backdropFoot", backdrop.foot);
    gl_.bindVertexArray(noVertices_.name());
    gl_.drawArrays(GL_TRIANGLES, 0, 3);
}

void OutsidePainter::draw(const SceneMeshes& meshes, const Projection& projection, const Backdrop& backdrop) {
    drawBackdrop(backdrop);
    program_.begin(projection);
    program_.set("smoothChecker", 1);
    const CameraAxes& axes = projection.axes();
    program_.set("keyLight", Vec3(glm::normalize(-0.45 * axes.right + 0.75 * axes.up + 0.7 * axes.backward)));
    program_.set("backdropTop", backdrop.top);
    program_.set("backdropFoot", backdrop.foot);
    program_.set("light", backdrop.light);
    program_.set("pictureHeight", static_cast<float>(projection.height()));
    const float fade = kFadeRadii * meshes.world()->radius;
    std::vector<const SceneItem*> clear;
    for (const SceneItem& item : meshes.items())
        item.surface.transmits() ? clear.push_back(&item) : drawItem(item, fade);

    const auto distance = [&](const SceneItem* item) {
        const DVec3 to = DVec3(item->toWorld[3]) - projection.eye();
        return glm::dot(to, to);
    };
    std::sort(clear.begin(), clear.end(),
              [&](const SceneItem* a, const SceneItem* b) { return distance(a) > distance(b); });
    gl_.depthMask(GL_FALSE);
    gl_.enable(GL_BLEND);
    gl_.blendEquation(GL_FUNC_ADD);
    gl_.blendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const SceneItem* item : clear) drawItem(*item, fade);
    gl_.disable(GL_BLEND);
    gl_.depthMask(GL_TRUE);
}

void OutsidePainter::drawItem(const SceneItem& item, float fade) {
    const Surface& s = item.surface;
    program_.set("base", baseOf(s));
    program_.set("shine", shineOf(s));
    program_.set("glow", s.emission);
    program_.set("gloss", std::min(0.35F, 0.5F * maxComponent(s.specular)));
    program_.set("glass", s.transmits() ? 1.0F : 0.0F);
    program_.set("fadeRadius", item.unbounded ? fade : 0.0F);
    program_.draw(item);
}

}
