#include "core/transport/emitter_shapes.h"

#include <algorithm>
#include <array>

namespace eyeray {
namespace {

constexpr double kSmallSolidAngle = 1e-3; // below it angles cancel, and area does as well

}

// A rectangle seen from a point, by the paper's names: its plane is z = z0 < 0 in a frame of its edges.
struct SphericalRectangle::Seen {
    DVec3 x, y, z;             // unit axes
    double x0, y0, z0, x1, y1; // corners
    double b0, b1, k, solidAngle;
};

SphericalRectangle::SphericalRectangle(const DVec3& center, const DVec3& edgeX, const DVec3& edgeY)
    : center_(center), edgeX_(edgeX), edgeY_(edgeY), normal_(safeNormalize(glm::cross(edgeX, edgeY))),
      area_(glm::length(glm::cross(edgeX, edgeY))) {
    constexpr double kRight = 1e-6; // cosine of an angle that is as good as right
    rectangular_ = std::fabs(glm::dot(safeNormalize(edgeX), safeNormalize(edgeY))) < kRight;
}

std::optional<SphericalRectangle::Seen> SphericalRectangle::seenFrom(const Vec3& from) const {
    if (!rectangular_) return std::nullopt;
    Seen s{};
    s.x = safeNormalize(edgeX_);
    s.y = safeNormalize(edgeY_);
    s.z = normal_; // towards the point, which lies in front
    const DVec3 corner = center_ - 0.5 * (edgeX_ + edgeY_) - DVec3(from);
    s.x0 = glm::dot(corner, s.x);
    s.y0 = glm::dot(corner, s.y);
    s.z0 = glm::dot(corner, s.z);
    s.x1 = s.x0 + glm::length(edgeX_);
    s.y1 = s.y0 + glm::length(edgeY_);
    // Normals of the planes through the point and the edges; only their z is needed.
    const auto edgeNormalZ = [&](double at) { return at / std::sqrt(s.z0 * s.z0 + at * at); };
    const std::array<double, 4> n = {edgeNormalZ(-s.y0), edgeNormalZ(s.x1), edgeNormalZ(s.y1),
                                     edgeNormalZ(-s.x0)};
    const auto angle = [&](std::size_t i, std::size_t j) {
        return std::acos(std::clamp(-n[i] * n[j], -1.0, 1.0));
    };
    const double g2 = angle(2, 3), g3 = angle(3, 0);
    s.b0 = n[0];
    s.b1 = n[2];
    s.k = 2 * kPiD - g2 - g3;
    s.solidAngle = angle(0, 1) + angle(1, 2) - s.k;
    if (!(s.solidAngle > kSmallSolidAngle)) return std::nullopt;
    return s;
}

std::optional<ShapeSample> SphericalRectangle::sample(const Vec3& from, const Vec2& u) const {
    if (!(glm::dot(normal_, DVec3(from) - center_) > 0)) return std::nullopt;
    const auto seen = seenFrom(from);
    if (!seen) return sampleByArea(from, u);
    const Seen& s = *seen;
    const double au = static_cast<double>(u.x) * s.solidAngle + s.k;
    const double fu = (std::cos(au) * s.b0 - s.b1) / std::sin(au);
    const double cu = std::clamp(std::copysign(1 / std::sqrt(fu * fu + s.b0 * s.b0), fu), -1.0, 1.0);
    const double xu = std::clamp(-(cu * s.z0) / std::sqrt(std::max(1 - cu * cu, 1e-30)), s.x0, s.x1);
    const double d2 = xu * xu + s.z0 * s.z0;
    const double h0 = s.y0 / std::sqrt(d2 + s.y0 * s.y0), h1 = s.y1 / std::sqrt(d2 + s.y1 * s.y1);
    const double hv = h0 + static_cast<double>(u.y) * (h1 - h0), hv2 = hv * hv;
    const double yv =
        hv2 < 1 - 1e-12 ? std::clamp(hv * std::sqrt(d2) / std::sqrt(1 - hv2), s.y0, s.y1) : s.y1;
    ShapeSample result = towards(from, DVec3(from) + xu * s.x + yv * s.y + s.z0 * s.z);
    result.pdfW = static_cast<float>(1 / s.solidAngle);
    return result;
}

float SphericalRectangle::pdfW(const Vec3& from, const Vec3& wi) const {
    if (const auto seen = seenFrom(from)) return static_cast<float>(1 / seen->solidAngle);
    const double cosine = -glm::dot(normal_, DVec3(wi));
    const double distance = glm::dot(normal_, DVec3(from) - center_) / cosine;
    return cosine > 0 ? static_cast<float>(distance * distance / (cosine * area_)) : 0;
}

std::optional<ShapeSample> SphericalRectangle::sampleByArea(const Vec3& from, const Vec2& u) const {
    const DVec3 point =
        center_ + (static_cast<double>(u.x) - 0.5) * edgeX_ + (static_cast<double>(u.y) - 0.5) * edgeY_;
    ShapeSample result = towards(from, point);
    if (!(result.emitterCosine > 0)) return std::nullopt;
    result.pdfW = static_cast<float>(static_cast<double>(result.distance) * result.distance /
                                     (result.emitterCosine * area_));
    return result;
}

ShapeSample SphericalRectangle::towards(const Vec3& from, const DVec3& point) const {
    const DVec3 to = point - DVec3(from);
    const double distance = glm::length(to);
    return {.wi = Vec3(to / distance),
            .distance = static_cast<float>(distance),
            .emitterCosine = static_cast<float>(-glm::dot(normal_, to) / distance)};
}

double SphericalRectangle::solidAngle(const Vec3& from) const {
    const auto seen = seenFrom(from);
    return seen ? seen->solidAngle : 0;
}

namespace {

constexpr double kNearSolidAngle =
    0.5; // of the rectangle around a disc: beyond it 1/r² varies by more than a third

/// From the square to the unit disc, areas in proportion.
DVec2 concentric(const Vec2& u) {
    const DVec2 v = 2.0 * DVec2(u) - 1.0;
    if (v == DVec2(0)) return v;
    const bool wide = std::fabs(v.x) > std::fabs(v.y);
    const double radius = wide ? v.x : v.y;
    const double turn = wide ? kPiD / 4 * (v.y / v.x) : kPiD / 2 - kPiD / 4 * (v.x / v.y);
    return radius * DVec2(std::cos(turn), std::sin(turn));
}

}

SphericalDisc::SphericalDisc(const DVec3& center, const DVec3& axisX, const DVec3& axisY, bool byArea)
    : center_(center), axisX_(axisX), axisY_(axisY),
      toUnit_(glm::inverse(DMat3(axisX, axisY, glm::cross(axisX, axisY)))),
      around_(center, 2.0 * axisX, 2.0 * axisY), area_(kPiD * glm::length(glm::cross(axisX, axisY))),
      byArea_(byArea) {}

bool SphericalDisc::near(const Vec3& from) const {
    return !byArea_ && around_.solidAngle(from) > kNearSolidAngle;
}

bool SphericalDisc::contains(const DVec3& point) const {
    const DVec3 p = toUnit_ * (point - center_);
    return p.x * p.x + p.y * p.y <= 1;
}

float SphericalDisc::densityByArea(const ShapeSample& s) const {
    return static_cast<float>(static_cast<double>(s.distance) * s.distance / (s.emitterCosine * area_));
}

std::optional<ShapeSample> SphericalDisc::sample(const Vec3& from, const Vec2& u) const {
    if (near(from)) {
        auto s = around_.sample(from, u);
        if (s && !contains(DVec3(from) + static_cast<double>(s->distance) * DVec3(s->wi)))
            return std::nullopt;
        return s;
    }
    const DVec2 p = concentric(u);
    ShapeSample s = around_.towards(from, center_ + p.x * axisX_ + p.y * axisY_);
    if (!(s.emitterCosine > 0)) return std::nullopt;
    s.pdfW = densityByArea(s);
    return s;
}

float SphericalDisc::pdfW(const Vec3& from, const Vec3& wi) const {
    if (near(from)) return around_.pdfW(from, wi);
    const DVec3 normal = safeNormalize(glm::cross(axisX_, axisY_));
    const double cosine = -glm::dot(normal, DVec3(wi));
    const double distance = glm::dot(normal, DVec3(from) - center_) / cosine;
    if (!(cosine > 0)) return 0;
    return densityByArea(
        {.wi = wi, .distance = static_cast<float>(distance), .emitterCosine = static_cast<float>(cosine)});
}

SphericalEllipsoid::SphericalEllipsoid(const DMat4& map)
    : center_(map[3]), map_(map), inverse_(glm::inverse(DMat3(map))) {}

namespace {

/// What a unit sphere around the origin looks like from a point: 1 − cos of its half angle, or all
/// directions.
double coneOf(const DVec3& from) {
    const double distance2 = glm::dot(from, from);
    if (distance2 <= 1) return 2;
    const double sine2 = 1 / distance2;
    return sine2 / (1 + std::sqrt(1 - sine2));
}

}

std::optional<ShapeSample> SphericalEllipsoid::sample(const Vec3& from, const Vec2& u) const {
    const DVec3 local = inverse_ * (DVec3(from) - center_);
    const double cone = coneOf(local), down = static_cast<double>(u.x) * cone; // 1 − cosine
    const double sine = std::sqrt(std::max(0.0, down * (2 - down))), turn = 2 * kPiD * u.y;
    const DVec3 axis = safeNormalize(-local);
    if (axis == DVec3(0)) return std::nullopt;
    const Frame frame = Frame::around(Vec3(axis));
    const DVec3 w = glm::normalize((1 - down) * axis + sine * (std::cos(turn) * DVec3(frame.tangent) +
                                                               std::sin(turn) * DVec3(frame.bitangent)));
    // The nearer hit of the unit sphere, or from inside the only one.
    const double along = -glm::dot(local, w);
    const DVec3 nearest = local + along * w;
    const double half = std::sqrt(std::max(0.0, 1 - glm::dot(nearest, nearest)));
    const double t = cone < 2 ? along - half : along + half;
    const DVec3 world = map_ * w;
    const double stretch = glm::length(world);
    ShapeSample result{.wi = Vec3(world / stretch), .distance = static_cast<float>(t * stretch)};
    result.pdfW = pdfW(from, result.wi);
    return result;
}

float SphericalEllipsoid::pdfW(const Vec3& from, const Vec3& wi) const {
    const double cone = coneOf(inverse_ * (DVec3(from) - center_));
    const double squeeze = glm::length(inverse_ * DVec3(wi));
    const double density = std::fabs(glm::determinant(inverse_)) / (squeeze * squeeze * squeeze);
    return static_cast<float>(density / (2 * kPiD * cone));
}

double SphericalEllipsoid::area() const {
    const double radius = std::cbrt(std::fabs(glm::determinant(DMat3(map_))));
    return 4 * kPiD * radius * radius;
}

SkyGradient::SkyGradient(const Environment& sky)
    : sky_(sky), zenith_(2 * kPi * luminance(sky.zenith) * (2.0F / 3)),
      horizon_(2 * kPi * luminance(sky.horizon) * (2.0F / 3)),
      nadir_(2 * kPi * luminance(sky.nadir) * (2.0F / 3)) {}

// With s = √|y| radiance is horizon·(1 − s) + zenith·s: y has density 3/2·√y for the zenith's part, and for
// the horizon's s has 6 s (1 − s), whose distribution 3s² − 2s³ is inverted by Vieta's cosine.
ShapeSample SkyGradient::sample(const Vec2& u) const {
    const float all = zenith_ + horizon_ + nadir_;
    float part = u.x * all, y = 0;
    if (part < zenith_) {
        y = std::cbrt(part / zenith_ * (part / zenith_));
    } else if (part < zenith_ + nadir_) {
        part = (part - zenith_) / nadir_;
        y = -std::cbrt(part * part);
    } else {
        part = 2 * (part - zenith_ - nadir_) / horizon_;
        const float half = part - std::floor(std::min(part, 1.9999999F));
        const float s = 0.5F - std::sin(std::asin(std::clamp(1 - 2 * half, -1.0F, 1.0F)) / 3);
        y = part < 1 ? s * s : -s * s;
    }
    const float sine = std::sqrt(std::max(0.0F, 1 - y * y)), turn = 2 * kPi * u.y;
    ShapeSample result{.wi = {sine * std::cos(turn), y, sine * std::sin(turn)}, .distance = kInfinity};
    result.pdfW = pdfW(result.wi);
    return result;
}

float SkyGradient::pdfW(const Vec3& wi) const {
    return luminance(sky_.radiance(wi)) / (zenith_ + horizon_ + nadir_);
}

}
