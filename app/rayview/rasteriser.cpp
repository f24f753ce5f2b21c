#include "app/rayview/rasteriser.h"

#include <algorithm>

#include "core/transport/lights.h"
#include "core/transport/trace_context.h"

namespace eyeray {
namespace {

constexpr double kNearest = 0.004, kFarthest = 2500; // radii of the scene

// As localModel and sampleLight of the tracer.
constexpr const char* kShading = R"(
uniform vec3 constant, diffuse, specular;
uniform float shininess, metallic;
uniform int blinn, object, lampCount;
uniform vec4 lamps[4 * 32];
layout(location = 0) out vec4 radiance;
layout(location = 1) out int objectId;

vec3 irradianceOverPi(int lamp, out vec3 wi) {
    vec4 place = lamps[4 * lamp], aim = lamps[4 * lamp + 1], light = lamps[4 * lamp + 2];
    vec2 cone = lamps[4 * lamp + 3].xy;
    int kind = int(place.w);
    wi = -aim.xyz;
    if (kind == 1) return light.rgb;
    vec3 to = place.xyz - position;
    float distance = length(to);
    if (!(distance > 0.0) || distance > light.w) return vec3(0.0);
    wi = to / distance;
    float cosine = -dot(aim.xyz, wi), factor = 1.0;
    if (kind == 3) factor = max(0.0, cosine);
    if (kind == 2) {
        float edge = clamp((cosine - cone.y) / max(cone.x - cone.y, 1e-4), 0.0, 1.0);
        factor = edge * edge;
    }
    return light.rgb * (aim.w != 0.0 ? factor / (distance * distance) : factor);
}

void main() {
    vec3 v = viewer(), n = facingNormal(), tint = textureColor();
    vec3 kd = diffuse * tint, ks = specular * mix(vec3(1.0), tint, metallic);
    vec3 sum = constant * tint;
    for (int lamp = 0; lamp < lampCount; ++lamp) {
        vec3 wi, irradiance = irradianceOverPi(lamp, wi);
        float cosine = dot(n, wi);
        if (!(cosine > 0.0)) continue;
        float lobe = blinn != 0 ? dot(n, normalize(wi + v)) : dot(2.0 * cosine * n - wi, v);
        sum += irradiance * (kd * cosine + (lobe > 0.0 ? ks * pow(lobe, shininess) : vec3(0.0)));
    }
    radiance = vec4(sum, 1.0);
    objectId = object;
}
)";

/// What rays see that hit nothing, where the depth buffer is empty.
void fillBackground(RasterPicture& picture, const World& world, const EyeRays& eyeRays) {
    for (int y = 0; y < picture.radiance.height(); ++y)
        for (int x = 0; x < picture.radiance.width(); ++x)
            if (!std::isfinite(picture.distance.at(x, y)))
                picture.radiance.at(x, y) =
                    world.scene->environment.radiance(eyeRays.through(x, y, Vec2(0.5F)).direction);
}

}

Rasteriser::Rasteriser(const Gl& gl) : gl_(gl), meshes_(gl), program_(gl, kShading) {}

RasterPicture Rasteriser::draw(const std::shared_ptr<const World>& world, const Camera& camera, int width,
                               int height) {
    if (!target_ || target_->width() != width || target_->height() != height)
        target_.emplace(gl_, width, height, std::vector<GLenum>{GL_RGBA32F, GL_R32I});
    meshes_.update(world);
    const double away = glm::length(camera.eye - world->origin), radius = world->radius;
    const Projection projection(camera, world->origin, width, height, kNearest * radius,
                                away + kFarthest * radius);
    constexpr std::array<GLfloat, 4> kBlack{0, 0, 0, 1};
    constexpr std::array<GLint, 4> kNone{-1, 0, 0, 0};
    constexpr GLfloat kFar = 1;
    target_->bind();
    program_.begin(projection);
    gl_.clearBufferfv(GL_COLOR, 0, kBlack.data());
    gl_.clearBufferiv(GL_COLOR, 1, kNone.data());
    gl_.clearBufferfv(GL_DEPTH, 0, &kFar);
    program_.set("smoothChecker", 0);
    setLamps(*world, camera);
    for (const SceneItem& item : meshes_.items()) {
        const Surface& s = item.surface;
        program_.set("constant", s.emission + s.ambient * world->scene->ambient);
        program_.set("diffuse", s.diffuse);
        program_.set("specular", s.specular);
        program_.set("shininess", s.shininess);
        program_.set("metallic", item.metallic);
        program_.set("blinn", s.specularModel == SpecularModel::BlinnPhong ? 1 : 0);
        program_.set("object", item.object);
        program_.draw(item);
    }

    RasterPicture picture;
    const auto radiance = target_->read<Vec4>(0, GL_RGBA, GL_FLOAT);
    picture.radiance = ColorImage(width, height);
    std::transform(radiance.values().begin(), radiance.values().end(), picture.radiance.values().begin(),
                   [](const Vec4& value) { return Color(value); });
    picture.objects = target_->read<int>(1, GL_RED_INTEGER, GL_INT);
    picture.distance = target_->readDepth();
    for (float& depth : picture.distance.values()) depth = depth < 1 ? projection.distance(depth) : kInfinity;
    gl_.bindFramebuffer(GL_FRAMEBUFFER, 0);
    fillBackground(picture, *world, EyeRays(camera, world->origin, width, height));
    return picture;
}

void Rasteriser::setLamps(const World& world, const Camera& camera) const {
    std::vector<Vec4> packed;
    int count = 0;
    for (const WorldLight& light : lightsFor(world, camera)) {
        if (count == kMostRasterLamps) break;
        packed.emplace_back(light.position, static_cast<float>(light.kind));
        packed.emplace_back(light.direction, light.falloff ? 1.0F : 0.0F);
        packed.emplace_back(light.emission / kPi, light.range);
        packed.emplace_back(light.cosInner, light.cosOuter, 0, 0);
        ++count;
    }
    program_.set("lamps", packed);
    program_.set("lampCount", count);
}

}
