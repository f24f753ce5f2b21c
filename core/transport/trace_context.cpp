#include "core/transport/trace_context.h"

#include "core/transport/lights.h"

namespace eyeray {
namespace {

/// Solids around a point, by parity along one ray: those hit an odd number of times.
MediumStack mediaAround(const World& world, const Vec3& point) {
    constexpr int kMostSurfaces = 256; // beyond it the answer is given up rather than the time
    if (!world.needs.refractions) return {};
    std::vector<std::uint32_t> odd;
    Ray ray{point, Vec3(0.4472136F, 0.7745967F, 0.4472136F)};
    std::visit(
        [&](const auto& geometry) {
            for (int i = 0; i < kMostSurfaces; ++i) {
                const auto hit = closestHit(geometry, ray, RayMask::Transparent);
                if (!hit) break;
                if (world.objects[hit->instance].solid && std::erase(odd, hit->instance) == 0)
                    odd.push_back(hit->instance);
                ray.origin = spawnOrigin(surfaceAt(geometry, ray, *hit), ray.direction);
            }
        },
        *world.accel);
    MediumStack media;
    for (const std::uint32_t instance : odd) media = media.entered(instance, world.objects[instance].rank);
    return media;
}

TraceSettings withoutNeedless(TraceSettings settings, const SceneNeeds& needs) {
    settings.diffuse &= settings.method == Method::Path && needs.physical.diffuse;
    if (isPhysical(settings.method)) {
        settings.shadows &= needs.physical.shadows;
        settings.reflections &= needs.physical.reflections;
        settings.refractions &= needs.refractions;
        return settings;
    }
    settings.shadows &= needs.shadows && settings.method != Method::Local;
    settings.reflections &= needs.reflections && settings.method == Method::Whitted;
    settings.refractions &= needs.refractions && settings.method == Method::Whitted;
    return settings;
}

}

EyeRays::EyeRays(const Camera& camera, const DVec3& origin, int width, int height, FaultSet faults)
    : frame_{.eye = Vec3(camera.eye - origin),
             .width = static_cast<float>(width),
             .height = static_cast<float>(height)} {
    const CameraAxes axes = axesOf(camera);
    const double fov = faults.has(Fault::DegreesAsRadians) ? degrees(camera.verticalFov) : camera.verticalFov;
    DVec2 half = imagePlaneHalfExtents(fov, static_cast<double>(width) / height);
    if (faults.has(Fault::HorizontalFov)) half *= static_cast<double>(height) / width;
    frame_.halfRight = Vec3(axes.right * half.x);
    frame_.halfUp = Vec3(axes.up * half.y);
    frame_.forward = Vec3(-axes.backward);
    lensRight_ = Vec3(axes.right * camera.lensRadius);
    lensUp_ = Vec3(axes.up * camera.lensRadius);
    focusDistance_ = static_cast<float>(camera.focusDistance > 0 ? camera.focusDistance : camera.distance());
}

Ray EyeRays::through(int x, int y, const Vec2& inPixel) const {
    if (!aims_.empty())
        if (const Vec3& aim = aims_[pixelIndex(x, y)]; isFinite(aim))
            return {frame_.eye, glm::normalize(aim - frame_.eye)};
    const float right = (2 * (static_cast<float>(x) + inPixel.x) - frame_.width) / frame_.width;
    const float up = (frame_.height - 2 * (static_cast<float>(y) + inPixel.y)) / frame_.height;
    return {frame_.eye, glm::normalize(frame_.forward + right * frame_.halfRight + up * frame_.halfUp)};
}

Ray EyeRays::fromLens(const Ray& through, const Vec2& u) const {
    if (!hasLens()) return through;
    const float radius = std::sqrt(u.x), angle = 2 * kPi * u.y;
    const Vec3 place = radius * (std::cos(angle) * lensRight_ + std::sin(angle) * lensUp_);
    const Vec3 sharp = through.direction * (focusDistance_ / glm::dot(through.direction, frame_.forward));
    return {frame_.eye + place, glm::normalize(sharp - place)};
}

TraceContext::TraceContext(std::shared_ptr<const World> traced, const Camera& camera,
                           const TraceSettings& asked, int w, int h, std::uint32_t seed_,
                           std::stop_token stop_)
    : world(std::move(traced)), settings(withoutNeedless(asked, world->needs)), width(w), height(h),
      seed(seed_), stop(std::move(stop_)), eyeRays(camera, world->origin, w, h, settings.faults),
      lights(lightsFor(*world, camera)),
      emitters(isPhysical(settings.method)
                   ? Emitters(*world, camera, settings.method == Method::Path && settings.shadows)
                   : Emitters()),
      eyeMedia(mediaAround(*world, Vec3(camera.eye - world->origin))),
      textbook(settings.faults.empty()
                   ? nullptr
                   : textbookGeometry(*world->accel, world->origin, settings.faults, settings.epsilon,
                                      settings.precision == Precision::Double)) {
    if (settings.aim == Aim::Edges) eyeRays.aimAtEdges(*world);
}

}
