#include "app/rayview/scene_meshes.h"

#include <algorithm>
#include <numeric>

namespace eyeray {
namespace {

template <class... Fs>
struct Overloaded : Fs... {
    using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

constexpr float kReach = 1000; // of infinite planes, in radii of the scene
constexpr int kFinest = 96;    // segments around a shape
constexpr int kCoarsest = 10;  // likewise
constexpr double kTriangles =
    600'000; // of all shapes, about: what software OpenGL draws in a tenth of a second

template <class T>
const T& at(const std::vector<T>& values, int id) {
    return values[static_cast<std::size_t>(id)];
}

/// Radius of an object in the scene, about; 0 for an unbounded one.
double radiusOf(const Scene& scene, const Object& object) {
    const auto* shape = std::get_if<ShapeId>(&object.geometry);
    if (shape == nullptr) return 0;
    const Bounds box = boundsOf(at(scene.shapes, shape->index));
    if (!box.finite()) return 0;
    const double scale = std::cbrt(std::fabs(glm::determinant(DMat3(object.transform))));
    return 0.5 * scale * static_cast<double>(glm::length(box.extent()));
}

/// Segments around each object's shape: larger ones have more, and all together stay drawable.
std::vector<int> segmentsOf(const Scene& scene) {
    std::vector<double> radii;
    radii.reserve(scene.objects.size());
    for (const Object& object : scene.objects) radii.push_back(radiusOf(scene, object));
    const double sum = std::accumulate(radii.begin(), radii.end(), 0.0);
    std::vector<int> segments;
    for (const double radius : radii) {
        const double wanted = std::sqrt(kTriangles * radius / std::max(sum, 1e-30));
        int taken = kCoarsest; // few different ones, so that objects share their triangles
        while (2 * taken <= std::min<double>(wanted, kFinest)) taken *= 2;
        segments.push_back(taken);
    }
    return segments;
}

/// Balls of every size share the unit ball.
Sphere unitShape(Sphere sphere, DMat4& transform) {
    for (int axis = 0; axis < 3; ++axis) transform[axis] *= sphere.radius;
    return {1};
}
template <class Other>
Other unitShape(const Other& shape, DMat4&) {
    return shape;
}

std::array<float, 3> measures(const Sphere& s) { return {s.radius}; }
std::array<float, 3> measures(const Plane& p) { return {p.sizeX, p.sizeZ, p.round ? 1.0F : 0.0F}; }
std::array<float, 3> measures(const Box& b) { return {b.size.x, b.size.y, b.size.z}; }
std::array<float, 3> measures(const Cylinder& c) { return {c.height, c.radiusTop, c.radiusBottom}; }

const TextureRef& colorTexture(const TaughtMaterial& m) { return m.diffuseTexture; }
const TextureRef& colorTexture(const GltfMaterial& m) { return m.baseColorTexture; }
float metallicOf(const TaughtMaterial&) { return 0; }
float metallicOf(const GltfMaterial& m) { return m.metallic; }

GLint wrapOf(Wrap wrap) {
    if (wrap == Wrap::Repeat) return GL_REPEAT;
    return wrap == Wrap::Mirror ? GL_MIRRORED_REPEAT : GL_CLAMP_TO_EDGE;
}

}

void SceneMeshes::update(const std::shared_ptr<const World>& world) {
    if (world == world_) return;
    world_ = world;
    items_.clear();
    const auto oldMeshes = std::exchange(triangleMeshes_, {});
    const auto oldShapes = std::exchange(shapeMeshes_, {});
    const auto oldImages = std::exchange(images_, {});
    const Scene& scene = *world_->scene;
    for (const Mesh& mesh : scene.meshes)
        if (const auto old = oldMeshes.find(mesh.triangles); old != oldMeshes.end())
            triangleMeshes_.insert(*old);
    shapeMeshes_ = oldShapes.size() < 4 * scene.shapes.size() + 64 ? oldShapes : decltype(oldShapes){};
    for (const Image& image : scene.images)
        if (const auto old = oldImages.find(image.pixels); old != oldImages.end()) images_.insert(*old);

    const std::vector<int> segments = segmentsOf(scene);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        addObject(scene.objects[i], static_cast<int>(i), segments[i]);
    for (const Light& light : scene.lights) addLamp(light);
}

void SceneMeshes::addObject(const Object& object, int id, int segments) {
    if (!object.visible) return;
    const Scene& scene = *world_->scene;
    const MaterialModel& model = at(scene.materials, object.material).model;
    SceneItem item;
    item.object = id;
    item.surface = at(world_->materials, object.material).surface;
    item.metallic = std::visit([](const auto& m) { return metallicOf(m); }, model);
    item.texture = textureOf(model);
    DMat4 transform = object.transform;
    std::visit(Overloaded{[&](MeshId mesh) {
                              const auto& triangles = at(scene.meshes, mesh.index).triangles;
                              item.mesh = triangleMesh(triangles);
                              item.flat = triangles->normals.empty();
                              item.oneSided = !triangles->doubleSided;
                          },
                          [&](ShapeId shape) {
                              const Shape& placed = at(scene.shapes, shape.index);
                              item.unbounded = !boundsOf(placed).finite();
                              const auto* plane = std::get_if<Plane>(&placed);
                              item.oneSided = plane != nullptr && !plane->doubleSided;
                              item.mesh = std::visit(
                                  [&](const auto& s) { return shapeMesh(unitShape(s, transform), segments); },
                                  placed);
                          }},
               object.geometry);
    place(std::move(item), transform);
}

void SceneMeshes::addLamp(const Light& light) {
    if (!light.enabled || light.followsCamera) return;
    SceneItem item;
    item.surface.emission = light.color * static_cast<float>(light.intensity);
    DMat4 transform = light.transform;
    const auto flat = [&](double width, double height, bool round) {
        const DMat4 yAxisToMinusZ{DVec4(1, 0, 0, 0), DVec4(0, 0, -1, 0), DVec4(0, 1, 0, 0),
                                  DVec4(0, 0, 0, 1)};
        transform = transform * yAxisToMinusZ;
        item.oneSided = true;
        item.mesh =
            shapeMesh(Plane{static_cast<float>(width), static_cast<float>(height), false, round}, kFinest);
    };
    std::visit(Overloaded{[&](const RectangleLamp& lamp) { flat(lamp.width, lamp.height, false); },
                          [&](const DiscLamp& lamp) { flat(2 * lamp.radius, 2 * lamp.radius, true); },
                          [&](const SphereLamp& lamp) {
                              const Sphere ball{static_cast<float>(lamp.radius)};
                              item.mesh = shapeMesh(unitShape(ball, transform), kFinest);
                          },
                          [](const auto&) {}},
               light.shape);
    if (item.mesh) place(std::move(item), transform);
}

void SceneMeshes::place(SceneItem item, const DMat4& transform) {
    const double determinant = glm::determinant(DMat3(transform));
    if (!std::isfinite(determinant) || determinant == 0) return;
    item.toWorld = transform;
    item.toWorld[3] -= DVec4(world_->origin, 0);
    items_.push_back(std::move(item));
}

SceneMeshes::MeshPtr SceneMeshes::shapeMesh(const Shape& shape, int segments) {
    const auto m = std::visit([](const auto& s) { return measures(s); }, shape);
    const float reach = kReach * world_->radius;
    const bool plane = std::holds_alternative<Plane>(shape);
    const ShapeKey key{static_cast<float>(shape.index()), plane ? reach : static_cast<float>(segments), m[0],
                       m[1], m[2]};
    MeshPtr& mesh = shapeMeshes_[key];
    if (mesh) return mesh;
    ++copied_;
    return mesh = std::make_shared<const GpuMesh>(gl_, tessellated(shape, segments, reach));
}

SceneMeshes::MeshPtr SceneMeshes::triangleMesh(const std::shared_ptr<const TriangleMesh>& triangles) {
    MeshPtr& mesh = triangleMeshes_[triangles];
    if (mesh) return mesh;
    ++copied_;
    return mesh = std::make_shared<const GpuMesh>(gl_, tessellated(*triangles));
}

ItemTexture SceneMeshes::textureOf(const MaterialModel& model) {
    const TextureRef& ref =
        std::visit([](const auto& m) -> const TextureRef& { return colorTexture(m); }, model);
    if (!ref.used() || ref.uvSet != 0) return {};
    ItemTexture texture;
    texture.offset = ref.transformed({0, 0});
    const Vec2 u = ref.transformed({1, 0}) - texture.offset, v = ref.transformed({0, 1}) - texture.offset;
    texture.row0 = {u.x, v.x};
    texture.row1 = {u.y, v.y};
    std::visit(Overloaded{[&](const CheckerTexture& checker) {
                              texture.kind = ItemTexture::Kind::Checker;
                              texture.even = checker.even;
                              texture.odd = checker.odd;
                          },
                          [&](const ImageTexture& image) {
                              texture.image = imageTexture(image);
                              if (texture.image) texture.kind = ItemTexture::Kind::Image;
                          }},
               at(world_->scene->textures, ref.texture).source);
    return texture;
}

std::shared_ptr<GlTexture> SceneMeshes::imageTexture(const ImageTexture& source) {
    const auto& pixels = at(world_->scene->images, source.image).pixels;
    if (!pixels || pixels->empty()) return nullptr;
    auto& texture = images_[pixels];
    if (!texture) {
        texture = std::make_shared<GlTexture>(gl_, source.nearest ? Magnify::Pixels : Magnify::Smooth);
        texture->upload(*pixels);
        gl_.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapOf(source.wrapU));
        gl_.texParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapOf(source.wrapV));
    }
    return texture;
}

}
