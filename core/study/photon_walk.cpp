#include "core/study/photon_walk.h"

#include "core/transport/bsdf.h"
#include "core/transport/next_rays.h"
#include "core/transport/optics.h"

namespace eyeray {
namespace {

constexpr Features kAll{.varying = true, .transparent = true};
constexpr std::uint32_t kPlacesPerStep = 4, kFirstStep = 8; // of the random numbers; before it the lamp's

/// One photon under way.
template <class Index>
class Walker {
public:
    Walker(const World& world, const IndexedGeometry<Index>& geometry,
           const std::vector<PhysicalSurface>& surfaces, const Lens& lens, const PhotonNumbers& numbers,
           PhotonPath& path)
        : world_(world), geometry_(geometry), surfaces_(surfaces), lens_(lens), numbers_(numbers),
          path_(path), power_(path.emitted.power) {}

    void go() {
        Ray ray{path_.emitted.origin, path_.emitted.direction, 0, path_.emitted.reach};
        while (step(ray)) {
        }
    }

private:
    /// To the next surface; true if the photon goes on from there along `ray`.
    bool step(Ray& ray) {
        const auto hit = closestHit(geometry_, ray, RayMask::Objects);
        const auto entered = lens_.entered(ray.origin, ray.direction);
        const bool seen = entered && *entered < (hit ? hit->t : ray.tMax);
        const float length = seen ? *entered : hit ? hit->t : ray.tMax;
        passMedium(length);
        path_.steps.push_back(
            {kind_, ray.origin, ray.at(std::isfinite(length) ? length : world_.radius), power_});
        if (seen || !hit) {
            path_.end = seen ? PhotonEnd::Lens : PhotonEnd::Escaped;
            return false;
        }
        path_.end = PhotonEnd::Absorbed;
        std::optional<Surface> own;
        const ShadingPoint p = shadingPointAt<kAll>(world_, geometry_, ray, *hit, own);
        path_.steps.back().to = p.at.position;
        const auto direction = scattered(p, surfaceOf(p, *hit));
        if (direction) ray = {spawnOrigin(p.at, *direction), *direction};
        return direction.has_value();
    }

    void passMedium(float length) {
        if (media_.top() == MediumStack::kVacuum) return;
        const WorldObject& medium = world_.objects[media_.top()];
        leave(power_ * transmittanceOf(world_.materials[medium.material].surface.attenuation, length));
    }

    PhysicalSurface surfaceOf(const ShadingPoint& p, const Hit& hit) const {
        const WorldMaterial& material = world_.materials[p.object->material];
        if (!material.varies && !p.object->vertexColors) return surfaces_[p.object->material];
        const auto uv = [&](int set) { return textureCoordinates(geometry_, p.at, hit, set); };
        return physicalAt(world_, material, uv, Color(vertexColor(geometry_, hit)));
    }

    /// Where the surface sends the photon on, if it does.
    std::optional<Vec3> scattered(const ShadingPoint& p, const PhysicalSurface& surface) {
        const auto steps = static_cast<std::uint32_t>(path_.steps.size());
        const std::uint32_t place = kFirstStep + kPlacesPerStep * steps;
        const bool bends = surface.transparency > 0;
        const Interface interface = bends ? interfaceAt(world_, p, media_) : Interface{1, media_};
        const Bsdf bsdf(surface, {.wo = p.wo,
                                  .normal = p.normal,
                                  .geometricNormal = p.geometricNormal,
                                  .eta = interface.eta,
                                  .thin = !p.object->solid});
        const auto sample =
            bsdf.pick(numbers_.single(place), {numbers_.single(place + 1), numbers_.single(place + 2)});
        const bool goesOn = sample && sample->probability > 0 && steps < PhotonWalk::kMostSteps;
        Color left = goesOn ? power_ * sample->weight / sample->probability : Color(0);
        const float share = maxComponent(left) / maxComponent(path_.emitted.power);
        if (share < PhotonWalk::kRoulette) {
            const float survives = share / PhotonWalk::kRoulette;
            left = numbers_(place + 3) < static_cast<double>(survives) ? left / survives : Color(0);
        }
        leave(left);
        if (isBlack(left)) return std::nullopt;
        kind_ = sample->kind;
        if (kind_ == RayKind::Refraction) media_ = interface.beyond;
        return sample->wi;
    }

    void leave(const Color& left) {
        path_.absorbed += power_ - left;
        power_ = left;
    }

    const World& world_;
    const IndexedGeometry<Index>& geometry_;
    const std::vector<PhysicalSurface>& surfaces_;
    const Lens& lens_;
    const PhotonNumbers& numbers_;
    PhotonPath& path_;
    Color power_;
    RayKind kind_ = RayKind::Shadow;
    MediumStack media_;
};

}

std::optional<float> Lens::entered(const Vec3& origin, const Vec3& direction) const {
    const float along = glm::dot(direction, forward);
    if (!(along < 0)) return std::nullopt;
    const float t = glm::dot(center - origin, forward) / along;
    if (!(t > 0)) return std::nullopt;
    const Vec3 off = origin + t * direction - center;
    return glm::dot(off, off) <= radius * radius ? std::optional(t) : std::nullopt;
}

Vec2 Lens::onPicture(const Vec3& point, const Vec3& direction) const {
    const Vec3 back = -direction / glm::dot(-direction, forward); // to the plane at distance 1
    const Vec3 sharp = point - center + focus * back;
    return Vec2(glm::dot(sharp, right), glm::dot(sharp, up)) / (focus * half);
}

Lens lensOf(const Camera& camera, const DVec3& origin, double aspect, double radius) {
    constexpr double kNearest = 1e-6; // metres: an eye may stand on its target
    const CameraAxes axes = axesOf(camera);
    return {.center = Vec3(camera.eye - origin),
            .right = Vec3(axes.right),
            .up = Vec3(axes.up),
            .forward = Vec3(-axes.backward),
            .radius = static_cast<float>(radius),
            .focus = static_cast<float>(std::max(camera.distance(), kNearest)),
            .half = Vec2(imagePlaneHalfExtents(camera.verticalFov, aspect))};
}

PhotonWalk::PhotonWalk(std::shared_ptr<const World> world, const Camera& camera, const Lens& lens,
                       std::uint32_t seed)
    : world_(std::move(world)), lamps_(*world_, camera), lens_(lens), seed_(seed) {
    for (const WorldMaterial& material : world_->materials)
        surfaces_.push_back(std::visit([](const auto& model) { return physicalOf(model); }, material.model));
}

void PhotonWalk::trace(std::uint64_t number, PhotonPath& path) const {
    const PhotonNumbers numbers(seed_, number);
    path.emitted = lamps_.emit(numbers);
    path.steps.clear();
    path.absorbed = Color(0);
    std::visit([&](const auto& geometry) { Walker(*world_, geometry, surfaces_, lens_, numbers, path).go(); },
               *world_->accel);
}

}
