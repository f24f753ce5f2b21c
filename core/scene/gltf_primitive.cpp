#include "core/scene/gltf_primitive.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "core/base/errors.h"
#include "core/scene/gltf_accessors.h"

namespace eyeray {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

class PrimitiveImport {
public:
    PrimitiveImport(GltfImport& context, const tinygltf::Primitive& source, const std::string& where)
        : context_(context), source_(source), where_(where) {}

    std::optional<TriangleMesh> run() {
        if (!hasTriangles()) return std::nullopt;
        vertices_ = accessorCount(context_.document, source_.attributes.at("POSITION"), where_ + ".POSITION");
        reserve();
        readPositions();
        readTriangles();
        dropBrokenTriangles();
        readNormals();
        readTextureCoordinates();
        readColors();
        if (mesh_.triangles.empty()) {
            context_.notes.ignored(where_ + ": has no triangle, it is left out");
            return std::nullopt;
        }
        return std::move(mesh_);
    }

private:
    bool hasTriangles() {
        if (source_.mode < 0 || source_.mode > TINYGLTF_MODE_TRIANGLE_FAN)
            throw InputError{where_, fmt::format("mode {} does not exist", source_.mode),
                             "export the file again"};
        if (source_.mode < TINYGLTF_MODE_TRIANGLES) {
            context_.notes.ignoredOne(source_.mode == TINYGLTF_MODE_POINTS ? "points" : "lines",
                                      "mesh primitive");
            return false;
        }
        if (!source_.attributes.contains("POSITION")) {
            context_.notes.ignored(where_ + ": has no positions, it is left out");
            return false;
        }
        return true;
    }

    std::size_t indexCount() const {
        return source_.indices >= 0 ? accessorCount(context_.document, source_.indices, where_ + ".indices")
                                    : vertices_;
    }

    /// Before any memory is taken.
    void reserve() {
        const bool list = source_.mode == TINYGLTF_MODE_TRIANGLES;
        const std::size_t indices = std::min(indexCount(), limits::kVertices),
                          triangles = list ? indices / 3 : indices;
        std::size_t vertexBytes = 0;
        for (const auto& attribute : source_.attributes)
            vertexBytes += attribute.first.starts_with("TEXCOORD") ? sizeof(Vec2) : sizeof(Vec4);
        context_.reserve(triangles,
                         triangles * sizeof(Triangle) + std::min(vertices_, limits::kVertices) * vertexBytes,
                         where_);
    }

    /// Values of an attribute as vectors; missing components are 1. None if the file does not have it.
    template <class V>
    std::vector<V> read(const std::string& name, std::initializer_list<int> components) {
        const auto found = source_.attributes.find(name);
        if (found == source_.attributes.end()) return {};
        const FloatElements elements = readFloats(context_.document, found->second, components);
        const auto width = static_cast<std::size_t>(elements.components);
        const std::size_t count = elements.values.size() / width;
        if (count != vertices_)
            throw InputError{where_,
                             fmt::format("{} has {} elements for {} positions", name, count, vertices_),
                             "export the file again"};
        std::vector<V> result(count, V(1));
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t c = 0; c < width; ++c)
                result[i][static_cast<int>(c)] = elements.values[i * width + c];
        return result;
    }

    void readPositions() { mesh_.positions = read<Vec3>("POSITION", {3}); }

    void readTriangles() {
        std::vector<std::uint32_t> order;
        if (source_.indices >= 0) {
            order = readIndices(context_.document, source_.indices);
        } else {
            order.resize(vertices_);
            std::iota(order.begin(), order.end(), 0U);
        }
        const std::size_t count = order.size();
        if (source_.mode == TINYGLTF_MODE_TRIANGLES) {
            if (count % 3 != 0)
                context_.notes.repaired(where_ + ": its last triangle is not whole, it is left out");
            mesh_.triangles.reserve(count / 3);
            for (std::size_t i = 0; i + 2 < count; i += 3)
                mesh_.triangles.push_back({order[i], order[i + 1], order[i + 2]});
        } else if (source_.mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
            for (std::size_t i = 0; i + 2 < count; ++i)
                mesh_.triangles.push_back({order[i], order[i + 1 + i % 2], order[i + 2 - i % 2]});
        } else {
            for (std::size_t i = 0; i + 2 < count; ++i)
                mesh_.triangles.push_back({order[i + 1], order[i + 2], order[0]});
        }
    }

    bool usable(std::uint32_t vertex) const {
        constexpr auto kMost = static_cast<float>(limits::kNumber);
        if (vertex >= vertices_) return false;
        const Vec3 p = glm::abs(mesh_.positions[vertex]);
        return p.x <= kMost && p.y <= kMost && p.z <= kMost;
    }

    void dropBrokenTriangles() {
        const std::size_t before = mesh_.triangles.size();
        std::erase_if(mesh_.triangles,
                      [&](const Triangle& t) { return !usable(t[0]) || !usable(t[1]) || !usable(t[2]); });
        if (const std::size_t dropped = before - mesh_.triangles.size(); dropped > 0)
            context_.notes.repaired(
                fmt::format("{}: {} of {} triangles have a vertex that does not exist or is not "
                            "finite, they are left out",
                            where_, dropped, before));
        const Vec3 instead = mesh_.triangles.empty() ? Vec3(0) : mesh_.positions[mesh_.triangles.front()[0]];
        for (std::uint32_t i = 0; i < vertices_; ++i)
            if (!usable(i)) mesh_.positions[i] = instead;
    }

    /// Sum of the normals of the triangles around a vertex, weighed by their areas.
    std::vector<DVec3> normalsOfTriangles() const {
        std::vector<DVec3> sums(vertices_, DVec3(0));
        for (const Triangle& t : mesh_.triangles) {
            const DVec3 a(mesh_.positions[t[0]]), b(mesh_.positions[t[1]]), c(mesh_.positions[t[2]]);
            for (const std::uint32_t vertex : t) sums[vertex] += glm::cross(b - a, c - a);
        }
        return sums;
    }

    void readNormals() {
        constexpr float kUnitError =
            1e-6F; // what rounding leaves; such normals stay as they are, bit for bit
        mesh_.normals = read<Vec3>("NORMAL", {3});
        std::vector<DVec3> instead;
        std::size_t broken = 0;
        for (std::size_t i = 0; i < mesh_.normals.size(); ++i) {
            Vec3& normal = mesh_.normals[i];
            if (std::fabs(glm::dot(normal, normal) - 1) < kUnitError) continue;
            DVec3 direction = safeNormalize(DVec3(normal));
            if (direction == DVec3(0)) {
                if (instead.empty()) instead = normalsOfTriangles();
                direction = safeNormalize(instead[i]);
                ++broken;
            }
            normal = direction == DVec3(0) ? Vec3(0, 1, 0) : Vec3(direction); // no triangle has an area here
        }
        if (broken > 0)
            context_.notes.repaired(fmt::format(
                "{}: {} normals are no direction, those of the triangles are used", where_, broken));
    }

    void readTextureCoordinates() {
        for (const auto& attribute : source_.attributes) {
            const std::string& name = attribute.first;
            if (!name.starts_with("TEXCOORD_")) continue;
            if (name.size() != 10 || name[9] < '0' || name[9] >= '0' + kUvSets) {
                context_.notes.ignoredOne("texture coordinates beyond the fourth set", "mesh primitive");
                continue;
            }
            auto& uvs = mesh_.uvs[static_cast<std::size_t>(name[9] - '0')];
            uvs = read<Vec2>(name, {2});
            repair(uvs, name);
        }
    }

    void readColors() {
        mesh_.colors = read<Vec4>("COLOR_0", {3, 4});
        repair(mesh_.colors, "COLOR_0");
        for (Vec4& color : mesh_.colors) color = glm::clamp(color, 0.0F, 1.0F);
        if (source_.attributes.contains("COLOR_1"))
            context_.notes.ignoredOne("second vertex colours", "mesh primitive");
    }

    template <class V>
    void repair(std::vector<V>& values, const std::string& name) {
        std::size_t broken = 0;
        for (V& value : values)
            if (!std::isfinite(glm::dot(value, V(0)))) { // 0 unless a component is not finite
                value = V(0);
                ++broken;
            }
        if (broken > 0)
            context_.notes.repaired(
                fmt::format("{}: {} values of {} are not finite, 0 is used", where_, broken, name));
    }

    GltfImport& context_;
    const tinygltf::Primitive& source_;
    const std::string& where_;
    std::size_t vertices_ = 0;
    TriangleMesh mesh_;
};

}

std::optional<TriangleMesh> importPrimitive(GltfImport& context, const tinygltf::Primitive& source,
                                            const std::string& where) {
    return PrimitiveImport(context, source, where).run();
}

}
