// What importers and edits promise about a Scene.

#include <algorithm>
#include <type_traits>

#include "core/base/errors.h"
#include "core/scene/scene.h"

namespace eyeray {

namespace {

bool inRange(int index, std::size_t size) { return index >= 0 && static_cast<std::size_t>(index) < size; }

bool finite(double v) { return std::isfinite(v); }
bool finite(const Vec2& v) { return finite(v.x) && finite(v.y); }
bool finite(const Vec3& v) { return isFinite(v); }
bool finite(const Vec4& v) { return isFinite(Vec3(v)) && finite(v.w); }
bool finite(const DVec3& v) { return isFinite(v); }

bool affine(const DMat4& m) {
    return finite(DVec3(m[0])) && finite(DVec3(m[1])) && finite(DVec3(m[2])) && finite(DVec3(m[3])) &&
           m[0].w == 0 && m[1].w == 0 && m[2].w == 0 && m[3].w == 1;
}

template <class T>
bool allFinite(const std::vector<T>& values) {
    return std::all_of(values.begin(), values.end(), [](const T& v) { return finite(v); });
}

void check(const TriangleMesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    const auto perVertex = [&](const auto& values) {
        return values.empty() || (values.size() == vertices && allFinite(values));
    };
    ENSURE(allFinite(mesh.positions));
    ENSURE(perVertex(mesh.normals));
    ENSURE(perVertex(mesh.colors));
    for (const auto& uvs : mesh.uvs) ENSURE(perVertex(uvs));
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle) ENSURE(index < vertices);
}

void check(const Shape& shape) {
    const auto positive = [](float v) { return v > 0 && std::isfinite(v); };
    if (const auto* const sphere = std::get_if<Sphere>(&shape)) ENSURE(positive(sphere->radius));
    if (const auto* const plane = std::get_if<Plane>(&shape)) ENSURE(plane->sizeX > 0 && plane->sizeZ > 0);
    if (const auto* const box = std::get_if<Box>(&shape))
        ENSURE(positive(box->size.x) && positive(box->size.y) && positive(box->size.z));
    if (const auto* const cylinder = std::get_if<Cylinder>(&shape)) {
        ENSURE(positive(cylinder->height) && positive(cylinder->radiusTop + cylinder->radiusBottom));
        ENSURE(cylinder->radiusTop >= 0 && cylinder->radiusBottom >= 0);
    }
}

void check(const Scene& scene, const Texture& texture) {
    if (const auto* const image = std::get_if<ImageTexture>(&texture.source)) {
        ENSURE(inRange(image->image, scene.images.size()));
    } else {
        const auto& checker = std::get<CheckerTexture>(texture.source);
        ENSURE(finite(checker.even) && finite(checker.odd));
    }
}

void check(const Scene& scene, const TextureRef& ref) {
    ENSURE(ref.texture < 0 || inRange(ref.texture, scene.textures.size()));
    ENSURE(inRange(ref.uvSet, kUvSets));
    ENSURE(finite(ref.offset) && finite(ref.scale) && finite(ref.rotation));
}

/// A checkerboard can be told apart from a picture only where it colours the surface.
void checkPicture(const Scene& scene, const TextureRef& ref) {
    check(scene, ref);
    ENSURE(!ref.used() || std::holds_alternative<ImageTexture>(scene.textures[ref.texture].source));
}

void check(const Scene& scene, const TaughtMaterial& m) {
    for (const Color& c :
         {m.ambient, m.diffuse, m.specular, m.reflectivity, m.transmission, m.attenuation, m.emission})
        ENSURE(finite(c) && minComponent(c) >= 0);
    ENSURE(m.shininess >= 0 && finite(m.shininess));
    ENSURE(m.ior > 0 && finite(m.ior));
    check(scene, m.diffuseTexture);
}

void check(const Scene& scene, const GltfMaterial& m) {
    for (const Color& c : {m.baseColor, m.emissive, m.specularColor, m.attenuationColor})
        ENSURE(finite(c) && minComponent(c) >= 0);
    for (const float v : {m.metallic, m.roughness, m.transmission, m.specular}) ENSURE(v >= 0 && v <= 1);
    for (const float v : {m.emissiveStrength, m.thickness}) ENSURE(v >= 0 && finite(v));
    ENSURE(m.ior > 0 && finite(m.ior));
    ENSURE(m.attenuationDistance > 0);
    check(scene, m.baseColorTexture);
    checkPicture(scene, m.metallicRoughnessTexture);
    checkPicture(scene, m.emissiveTexture);
    checkPicture(scene, m.transmissionTexture);
}

void check(const Scene& scene, const Object& object) {
    if (const auto* const mesh = std::get_if<MeshId>(&object.geometry))
        ENSURE(inRange(mesh->index, scene.meshes.size()));
    else
        ENSURE(inRange(std::get<ShapeId>(object.geometry).index, scene.shapes.size()));
    ENSURE(inRange(object.material, scene.materials.size()));
    ENSURE(affine(object.transform));
}

void check(const Light& light) {
    ENSURE(finite(light.color) && minComponent(light.color) >= 0);
    ENSURE(light.intensity >= 0 && finite(light.intensity));
    ENSURE(light.range > 0);
    ENSURE(affine(light.transform));
    if (const auto* const spot = std::get_if<SpotLamp>(&light.shape))
        ENSURE(spot->innerCone >= 0 && spot->innerCone < spot->outerCone && spot->outerCone <= kPiD / 2);
    if (const auto* const rectangle = std::get_if<RectangleLamp>(&light.shape))
        ENSURE(rectangle->width > 0 && rectangle->height > 0 && finite(rectangle->width) &&
               finite(rectangle->height));
    if (const auto* const disc = std::get_if<DiscLamp>(&light.shape))
        ENSURE(disc->radius > 0 && finite(disc->radius));
    if (const auto* const sphere = std::get_if<SphereLamp>(&light.shape))
        ENSURE(sphere->radius > 0 && finite(sphere->radius));
}

void check(const Camera& camera) {
    ENSURE(finite(camera.eye) && finite(camera.target) && finite(camera.up));
    ENSURE(camera.verticalFov > 0 && camera.verticalFov < kPiD);
    ENSURE(camera.aspect >= 0 && finite(camera.aspect));
    ENSURE(camera.lensRadius >= 0 && finite(camera.lensRadius));
    ENSURE(camera.focusDistance >= 0 && finite(camera.focusDistance));
}

}

void validate(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
        ENSURE(mesh.triangles != nullptr);
        check(*mesh.triangles);
    }
    for (const Shape& shape : scene.shapes) check(shape);
    for (const Image& image : scene.images) ENSURE(image.pixels != nullptr && !image.pixels->empty());
    for (const Texture& texture : scene.textures) check(scene, texture);
    for (const Material& material : scene.materials)
        std::visit([&](const auto& model) { check(scene, model); }, material.model);
    for (const Object& object : scene.objects) check(scene, object);
    for (const Light& light : scene.lights) check(light);
    for (const Camera& camera : scene.cameras) check(camera);
    ENSURE(!scene.materials.empty());
    ENSURE(!scene.cameras.empty());
    ENSURE(finite(scene.ambient));
    for (const Color& c : {scene.environment.zenith, scene.environment.horizon, scene.environment.nadir})
        ENSURE(finite(c));
}

}
