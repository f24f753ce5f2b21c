#include "core/scene/geometry_notes.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "core/geometry/coincident_faces.h"
#include "core/scene/needs.h"

namespace eyeray {
namespace {

constexpr std::size_t kTriangles = 200'000, kPairs = 64;

struct Place {
    std::array<float, 3> position;
    std::uint32_t vertex;
};

/// For each vertex the first one in the same place: files part vertices where normals or texture coordinates
/// differ.
std::vector<std::uint32_t> welded(const TriangleMesh& mesh) {
    std::vector<Place> places;
    places.reserve(mesh.positions.size());
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i)
        places.push_back({toArray(mesh.positions[i] + Vec3(0)), i}); // + 0: one zero
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
        return std::pair(a.position, a.vertex) < std::pair(b.position, b.vertex);
    });
    std::vector<std::uint32_t> first(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const bool same = i > 0 && places[i].position == places[i - 1].position;
        first[places[i].vertex] = same ? first[places[i - 1].vertex] : places[i].vertex;
    }
    return first;
}

/// Edges that do not belong to two triangles.
std::size_t openEdges(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> vertex = welded(mesh);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& [a, b, c] : mesh.triangles)
        for (const auto& [p, q] : {std::pair(a, b), {b, c}, {c, a}})
            if (vertex[p] != vertex[q]) edges.emplace_back(std::minmax(vertex[p], vertex[q]));
    std::sort(edges.begin(), edges.end());
    std::size_t open = 0;
    for (auto edge = edges.begin(); edge != edges.end();) {
        const auto next = std::find_if(edge, edges.end(), [&](const auto& e) { return e != *edge; });
        if (next - edge != 2) ++open;
        edge = next;
    }
    return open;
}

class Checks {
public:
    Checks(const Scene& scene, GltfNotes& notes, const std::stop_token& stop)
        : scene_(scene), notes_(notes), stop_(stop) {}

    void run() {
        openGlass();
        if (triangles() <= kTriangles) sharedPlaces();
    }

private:
    std::size_t triangles() const {
        std::size_t count = 0;
        for (const Mesh& mesh : scene_.meshes) count += mesh.triangles->triangles.size();
        return count;
    }

    const TriangleMesh* meshOf(const Object& object) const {
        const auto* mesh = std::get_if<MeshId>(&object.geometry);
        return mesh != nullptr ? scene_.meshes[static_cast<std::size_t>(mesh->index)].triangles.get()
                               : nullptr;
    }

    bool transparent(const Object& object) const {
        return needsOf(scene_.materials[static_cast<std::size_t>(object.material)].model).transmits;
    }

    bool solid(const Object& object) const {
        const auto* shape = std::get_if<ShapeId>(&object.geometry);
        return shape == nullptr || isSolid(scene_.shapes[static_cast<std::size_t>(shape->index)]);
    }

    void openGlass() {
        std::map<const TriangleMesh*, std::size_t> known;
        for (const Object& object : scene_.objects) {
            const TriangleMesh* mesh = meshOf(object);
            if (mesh == nullptr || !transparent(object) || mesh->triangles.size() > kTriangles) continue;
            const auto [entry, added] = known.try_emplace(mesh, 0);
            if (added) entry->second = openEdges(*mesh);
            if (entry->second == 0) continue;
            notes_.doubtful(
                fmt::format("{} is transparent, but {} of its edges do not join two triangles: light "
                            "that enters a mesh with gaps may never leave it",
                            object.name, entry->second));
        }
    }

    void sharedPlaces() {
        place();
        for (const auto& [a, b] : meetingPairs<Bvh2>(instances_, ids_, kPairs)) {
            if (stop_.stop_requested()) return;
            const Object &one = *objects_[a], &other = *objects_[b];
            if (one.material == other.material || (transparent(one) && transparent(other))) continue;
            const SharedFaces shared = sharedFaces(instances_[a], instances_[b]);
            const bool bothSeen = shared == SharedFaces::Alike ||
                                  (shared == SharedFaces::Opposed && !solid(one) && !solid(other));
            if (!bothSeen) continue;
            notes_.doubtful(
                fmt::format("{} and {} have faces in the same place: which of them is seen is a matter "
                            "of rounding; leave a gap between them",
                            one.name, other.name));
        }
    }

    void place() {
        std::map<const TriangleMesh*, std::shared_ptr<const IndexedMesh<Bvh2>>> known;
        const DVec3 origin = boundsOf(scene_).empty() ? DVec3(0) : boundsOf(scene_).center();
        for (const Object& object : scene_.objects) {
            DMat4 transform = object.transform;
            transform[3] -= DVec4(origin, 0);
            const double determinant = glm::determinant(DMat3(transform));
            if (!object.visible || !std::isfinite(determinant) || determinant == 0) continue;
            Instance<Bvh2> instance{.placement = Placement(transform), .geometry = Shape{}};
            if (const auto* shape = std::get_if<ShapeId>(&object.geometry)) {
                instance.geometry = scene_.shapes[static_cast<std::size_t>(shape->index)];
            } else {
                const auto id = static_cast<std::size_t>(std::get<MeshId>(object.geometry).index);
                const auto& mesh = scene_.meshes[id].triangles;
                auto& indexed = known[mesh.get()];
                if (indexed == nullptr) indexed = indexMesh<Bvh2>(mesh, stop_);
                instance.geometry = indexed;
            }
            ids_.push_back(static_cast<std::uint32_t>(instances_.size()));
            instances_.push_back(std::move(instance));
            objects_.push_back(&object);
        }
    }

    const Scene& scene_;
    GltfNotes& notes_;
    const std::stop_token& stop_;
    std::vector<Instance<Bvh2>> instances_;
    std::vector<const Object*> objects_;
    std::vector<std::uint32_t> ids_;
};

}

void noteGeometry(const Scene& scene, GltfNotes& notes, const std::stop_token& stop) {
    Checks(scene, notes, stop).run();
}

}
