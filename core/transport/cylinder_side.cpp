#include "core/transport/cylinder_side.h"

#include <algorithm>

namespace eyeray {
namespace {

/// Around the axis and along the side, per radian of a circle of radius 1 and per unit of height.
struct Tangents {
    DVec3 around, along;
    Tangents(const DMat3& map, double slope, double turn)
        : around(map * DVec3(-std::sin(turn), 0, std::cos(turn))),
          along(map * DVec3(slope * std::cos(turn), 1, slope * std::sin(turn))) {}
};

constexpr double kLeastAside = 1e-3; // of its height: so that a place at the side itself sees all of it

}

/// What lies before a place, in the frame of the cylinder.
struct CylinderSide::Seen {
    double height;      // of the place, along the axis
    double turn;        // of the place, around the axis
    double halfTurn;    // of the generators that face it
    double aside;       // how far away they are
    double first, last; // angles under which it sees their ends

    double spread() const { return last - first; }
};

CylinderSide::CylinderSide(const Cylinder& c, const DMat4& map)
    : center_(map[3]), map_(map), inverse_(glm::inverse(map_)), half_(0.5 * c.height),
      middle_(0.5 * (static_cast<double>(c.radiusTop) + c.radiusBottom)),
      slope_((static_cast<double>(c.radiusTop) - c.radiusBottom) / c.height), area_(0) {
    constexpr int kSteps = 64; // of a smooth periodic function
    const double step = 2 * kPiD / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const Tangents t(map_, slope_, i * step);
        area_ += step * c.height * middle_ * glm::length(glm::cross(t.around, t.along));
    }
}

std::optional<CylinderSide::Seen> CylinderSide::seenFrom(const Vec3& from) const {
    const DVec3 p = inverse_ * (DVec3(from) - center_);
    // A generator faces p if the cosine of its turn from p's own is above radius / distance at the height of
    // p, where the radius may be that of the mirrored cone beyond the apex.
    const double distance = std::hypot(p.x, p.z), radius = radiusAt(p.y);
    if (distance <= radius && std::fabs(p.y) > half_) return std::nullopt;
    const bool inside = distance <= radius;
    const double halfTurn = inside || distance <= -radius ? kPiD : std::acos(radius / distance);
    const double tangent = std::sqrt(std::fabs(distance * distance - radius * radius));
    const double aside = std::max(tangent, 2 * half_ * kLeastAside);
    return Seen{p.y,
                std::atan2(p.z, p.x),
                halfTurn,
                aside,
                std::atan((-half_ - p.y) / aside),
                std::atan((half_ - p.y) / aside)};
}

float CylinderSide::density(const Seen& seen, double turn, double y, const DVec3& to) const {
    const double up = y - seen.height;
    const double perHeight = seen.aside / (seen.spread() * (seen.aside * seen.aside + up * up));
    const Tangents t(map_, slope_, turn);
    const double distance = glm::length(to);
    const double facing = radiusAt(y) * std::fabs(glm::dot(glm::cross(t.around, t.along), to)) / distance;
    return static_cast<float>(distance * distance * perHeight / (2 * seen.halfTurn * facing));
}

std::optional<ShapeSample> CylinderSide::sample(const Vec3& from, const Vec2& u) const {
    const auto seen = seenFrom(from);
    if (!seen || !(seen->halfTurn > 0)) return std::nullopt;
    const double turn = seen->turn + (2.0 * static_cast<double>(u.x) - 1) * seen->halfTurn;
    const double angle = seen->first + static_cast<double>(u.y) * seen->spread();
    const double y = std::clamp(seen->height + seen->aside * std::tan(angle), -half_, half_);
    const double radius = radiusAt(y);
    const DVec3 to =
        map_ * DVec3(radius * std::cos(turn), y, radius * std::sin(turn)) + center_ - DVec3(from);
    const double distance = glm::length(to);
    const float pdfW = density(*seen, turn, y, to);
    if (!std::isfinite(pdfW)) return std::nullopt;
    return ShapeSample{.wi = Vec3(to / distance), .distance = static_cast<float>(distance), .pdfW = pdfW};
}

float CylinderSide::pdfW(const Vec3& from, const Vec3& wi, float distance) const {
    const auto seen = seenFrom(from);
    if (!seen || !(seen->halfTurn > 0)) return 0;
    const DVec3 to = static_cast<double>(distance) * DVec3(wi);
    const DVec3 p = inverse_ * (DVec3(from) + to - center_);
    const float pdfW = density(*seen, std::atan2(p.z, p.x), std::clamp(p.y, -half_, half_), to);
    return std::isfinite(pdfW) ? pdfW : 0;
}

}
