#include "tests/bench/rays/embree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstring>

namespace eyeray::bench {

struct EmbreeScene::Handles {
    RTCDevice device = rtcNewDevice("threads=2");
    RTCScene scene = rtcNewScene(device);
    std::atomic<std::int64_t> bytes = 0;

    ~Handles() {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

EmbreeScene::EmbreeScene(const TriangleMesh& mesh, bool robust) : handles_(std::make_unique<Handles>()) {
    const auto [device, scene] = std::pair(handles_->device, handles_->scene);
    rtcSetSceneFlags(scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Vec3), mesh.positions.size());
    std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3));
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              sizeof(mesh.triangles[0]), mesh.triangles.size());
    std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    const auto monitor = [](void* bytes, ssize_t change, bool) {
        *static_cast<std::atomic<std::int64_t>*>(bytes) += change;
        return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device, monitor, &handles_->bytes);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(scene);
    buildSeconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

EmbreeScene::~EmbreeScene() = default;

std::size_t EmbreeScene::bytes() const { return static_cast<std::size_t>(handles_->bytes.load()); }

namespace {

RTCRay converted(const Ray& ray) {
    RTCRay result{};
    result.org_x = ray.origin.x;
    result.org_y = ray.origin.y;
    result.org_z = ray.origin.z;
    result.dir_x = ray.direction.x;
    result.dir_y = ray.direction.y;
    result.dir_z = ray.direction.z;
    result.tnear = ray.tMin;
    result.tfar = ray.tMax;
    result.mask = 0xffffffff;
    return result;
}

}

float EmbreeScene::closest(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{.ray = converted(ray), .hit = {}};
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(handles_->scene, &context, &hit);
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kInfinity : hit.ray.tfar;
}

bool EmbreeScene::any(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay shadow = converted(ray);
    rtcOccluded1(handles_->scene, &context, &shadow);
    return shadow.tfar < 0;
}

namespace {

constexpr std::size_t kPacket = 16;

struct Valid {
    alignas(64) int lane[kPacket];

    explicit Valid(std::size_t count) {
        for (std::size_t i = 0; i < kPacket; ++i) lane[i] = i < count ? -1 : 0;
    }
};

RTCIntersectContext coherent() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

void put(RTCRay16& packet, const RayColumns& rays, std::size_t first) {
    const auto copy = [first](const std::vector<float>& column, float* to) {
        std::copy_n(&column[first], kPacket, to);
    };
    copy(rays.origin[0], packet.org_x), copy(rays.origin[1], packet.org_y),
        copy(rays.origin[2], packet.org_z);
    copy(rays.direction[0], packet.dir_x), copy(rays.direction[1], packet.dir_y);
    copy(rays.direction[2], packet.dir_z);
    copy(rays.tMin, packet.tnear), copy(rays.tMax, packet.tfar);
    std::fill_n(packet.mask, kPacket, 0xffffffff);
}

}

void EmbreeScene::closest(const RayColumns& rays, std::vector<float>& answers) const {
    static_assert(kPacket <= RayColumns::kSpare);
    RTCIntersectContext context = coherent();
    RTCRayHit16 packet{};
    for (std::size_t first = 0; first < rays.size; first += kPacket) {
        const std::size_t count = std::min(kPacket, rays.size - first);
        put(packet.ray, rays, first);
        std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
        const Valid valid(count);
        rtcIntersect16(valid.lane, handles_->scene, &context, &packet);
        for (std::size_t i = 0; i < count; ++i)
            answers[first + i] =
                packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kInfinity : packet.ray.tfar[i];
    }
}

void EmbreeScene::any(const RayColumns& rays, std::vector<float>& answers) const {
    RTCIntersectContext context = coherent();
    RTCRay16 packet{};
    for (std::size_t first = 0; first < rays.size; first += kPacket) {
        const std::size_t count = std::min(kPacket, rays.size - first);
        put(packet, rays, first);
        const Valid valid(count);
        rtcOccluded16(valid.lane, handles_->scene, &context, &packet);
        for (std::size_t i = 0; i < count; ++i) answers[first + i] = packet.tfar[i] < 0 ? 1.0F : 0.0F;
    }
}

}
