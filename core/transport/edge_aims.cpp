// Eye rays that go exactly at the edges of meshes.

#include <algorithm>
#include <cmath>

#include "core/transport/trace_context.h"

namespace eyeray {

void EyeRays::aimAtEdges(const World& world) {
    aims_.assign(static_cast<std::size_t>(frame_.width) * static_cast<std::size_t>(frame_.height), Vec3(NAN));
    for (const Object& object : world.scene->objects) {
        const auto* const id = std::get_if<MeshId>(&object.geometry);
        if (id == nullptr || !object.visible) continue;
        const TriangleMesh& mesh = *world.scene->meshes[static_cast<std::size_t>(id->index)].triangles;
        std::vector<Vec3> corners;
        corners.reserve(mesh.positions.size());
        for (const Vec3& position : mesh.positions)
            corners.emplace_back(transformPoint(object.transform, DVec3(position)) - world.origin);
        for (const auto& [a, b, c] : mesh.triangles) {
            aimAlong(corners[a], corners[b]);
            aimAlong(corners[b], corners[c]);
            aimAlong(corners[c], corners[a]);
        }
    }
}

/// At a place of the edge in each pixel that it crosses, its ends among them.
void EyeRays::aimAlong(const Vec3& from, const Vec3& to) {
    const Vec3 a = onScreen(from), b = onScreen(to);
    if (!(a.z > 0 && b.z > 0)) return; // an end lies behind the eye
    const float most = 4 * (frame_.width + frame_.height);
    const auto steps = static_cast<int>(
        std::ceil(std::clamp(std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y)), 1.0F, most)));
    aimAt(from);
    aimAt(to);
    for (int i = 1; i < steps; ++i) {
        const float s = static_cast<float>(i) / static_cast<float>(steps); // of the way on the screen
        aimAt(glm::mix(from, to, s * a.z / ((1 - s) * b.z + s * a.z)));
    }
}

void EyeRays::aimAt(const Vec3& place) {
    const Vec3 at = onScreen(place);
    if (!(at.x >= 0 && at.x < frame_.width && at.y >= 0 && at.y < frame_.height)) return;
    Vec3& aim = aims_[pixelIndex(static_cast<int>(at.x), static_cast<int>(at.y))];
    const auto distance = [&](const Vec3& p) { return glm::dot(p - frame_.eye, p - frame_.eye); };
    if (!isFinite(aim) || distance(place) < distance(aim)) aim = place;
}

Vec3 EyeRays::onScreen(const Vec3& place) const {
    const Vec3 seen = place - frame_.eye;
    const float depth = glm::dot(seen, frame_.forward);
    const float right =
                    glm::dot(seen, frame_.halfRight) / (glm::dot(frame_.halfRight, frame_.halfRight) * depth),
                up = glm::dot(seen, frame_.halfUp) / (glm::dot(frame_.halfUp, frame_.halfUp) * depth);
    return {(right + 1) / 2 * frame_.width, (1 - up) / 2 * frame_.height, depth};
}

}
