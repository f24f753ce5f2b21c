// The materials of several hits at once, textures read: the same bits as shadingPointAt finds for one.
// Compiled once for each instruction set, as core/base/lanes.h.
#if defined(EYERAY_STREAM_MATERIALS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EYERAY_STREAM_MATERIALS_H
#undef EYERAY_STREAM_MATERIALS_H
#else
#define EYERAY_STREAM_MATERIALS_H
#endif

#include "core/geometry/accel_lanes.h"
#include "core/scene/world_surface.h"
#include "core/transport/stream_shading.h"

HWY_BEFORE_NAMESPACE();
namespace eyeray::HWY_NAMESPACE {

/// As textureValue of a checkerboard, read at (x, z) of the points on a plane.
inline Vec3Lanes checkerOnPlane(const CheckerTexture& checker, const TextureRef& ref,
                                const Placement& placement, const Vec3Lanes& position) {
    const Affine& map = placement.worldToObject();
    const Vec3Lanes local = times(map.linear, position) + all(map.translation);
    const auto c = all(std::cos(ref.rotation)), s = all(std::sin(ref.rotation));
    const auto x = all(ref.scale.x) * local.x, y = all(ref.scale.y) * local.z;
    const auto u = all(ref.offset.x) + c * x + s * y, v = all(ref.offset.y) - s * x + c * y;
    const auto parity = hn::Floor(u) + hn::Floor(v);
    const auto even = parity - all(2.0F) * hn::Floor(parity * all(0.5F)) == hn::Zero(FloatTag());
    return select(even, all(checker.even), all(checker.odd));
}

/// As detail::diffuseFactor.
template <class Index>
Vec3Lanes diffuseFactors(const Scene& scene, const IndexedGeometry<Index>& geometry,
                         const TaughtMaterial& material, const Vec3Lanes& position, const HitLanes& hits,
                         FloatMask asked) {
    const TextureRef& ref = material.diffuseTexture;
    const auto* checker =
        ref.used()
            ? std::get_if<CheckerTexture>(&scene.textures[static_cast<std::size_t>(ref.texture)].source)
            : nullptr;
    Vec3Lanes factors = all(Color(1));
    eachInstance(hits.instance, asked, [&](std::uint32_t id, FloatMask lanes) HWY_ATTR {
        const Instance<Index>& instance = geometry.instances[id];
        const auto* shape = std::get_if<Shape>(&instance.geometry);
        if (checker != nullptr && shape != nullptr && std::holds_alternative<Plane>(*shape)) {
            factors = select(lanes, checkerOnPlane(*checker, ref, instance.placement, position), factors);
            return;
        }
        const Spread3 positions = spread(position);
        const HitSpread spreadHits(hits);
        Spread3 single = spread(factors);
        eachLane(lanes, [&](std::size_t lane) {
            const Hit hit = spreadHits.at(lane);
            SurfacePoint point;
            point.position = positions.at(lane);
            const auto uv = [&](int set) { return textureCoordinates(geometry, point, hit, set); };
            single.set(lane,
                       eyeray::detail::diffuseFactor(scene, material, uv, Color(vertexColor(geometry, hit))));
        });
        factors = gathered(single);
    });
    return factors;
}

/// Surfaces of a material that varies, at hits of the `asked` lanes.
template <class Index>
void varyingSurfaces(const World& world, const IndexedGeometry<Index>& geometry,
                     const WorldMaterial& material, const Vec3Lanes& position, const HitLanes& hits,
                     FloatMask asked, std::array<Surface, kLanes>& surfaces) {
    const Spread3 positions = spread(position);
    const HitSpread spreadHits(hits);
    surfaces.fill(material.surface);
    eachLane(asked, [&](std::size_t lane) {
        const Hit hit = spreadHits.at(lane);
        SurfacePoint point;
        point.position = positions.at(lane);
        const auto uv = [&](int set) { return textureCoordinates(geometry, point, hit, set); };
        surfaces[lane] = eyeray::surfaceAt(world, material, uv, Color(vertexColor(geometry, hit)));
    });
}

/// The material at hits of the `asked` lanes, which all have the one of this number. `own` is to live as
/// long: it holds the surfaces of one that varies.
template <class Index>
MaterialLanes materialAt(const World& world, const IndexedGeometry<Index>& geometry, std::uint32_t number,
                         const Vec3Lanes& position, const HitLanes& hits, FloatMask asked,
                         std::array<Surface, kLanes>& own) {
    const FloatTag f;
    const WorldMaterial& material = world.materials[number];
    if (!world.needs.textures) return MaterialLanes(material.surface);
    auto varies = hn::MaskFromVec(hn::Zero(f));
    eachInstance(hits.instance, asked, [&](std::uint32_t id, FloatMask lanes) HWY_ATTR {
        if (material.varies || world.objects[id].vertexColors) varies = hn::Or(varies, lanes);
    });
    if (hn::AllFalse(f, varies)) return MaterialLanes(material.surface);
    if (const auto* taught = std::get_if<TaughtMaterial>(&material.model))
        return MaterialLanes(material.surface,
                             diffuseFactors(*world.scene, geometry, *taught, position, hits, varies));
    varyingSurfaces(world, geometry, material, position, hits, varies, own);
    return MaterialLanes(own);
}

}
HWY_AFTER_NAMESPACE();

#endif
