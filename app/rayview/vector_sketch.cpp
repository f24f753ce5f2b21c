#include <algorithm>

#include <fmt/format.h>

#include "app/rayview/ray_sketch.h"

namespace eyeray {
namespace {

constexpr float kLength = 62; // of a vector, pixels at scale 1 where it lies in the picture's plane
constexpr float kArc = 0.45F; // radius of the arcs, in lengths of a vector
constexpr double kLeastAngle = radians(1); // smaller ones have no arc

double angleBetween(const Vec3& a, const Vec3& b) {
    const DVec3 x(a), y(b);
    return std::atan2(glm::length(glm::cross(x, y)), glm::dot(x, y));
}

/// A point on the great circle from a to b, both unit.
Vec3 between(const Vec3& a, const Vec3& b, float share) {
    const auto angle = static_cast<float>(angleBetween(a, b));
    return (std::sin((1 - share) * angle) * a + std::sin(share * angle) * b) / std::sin(angle);
}

class VectorPainter {
public:
    VectorPainter(Sketch& sketch, const Projection& projection, const RayStyle& style, const Vec3& at)
        : sketch_(sketch), projection_(projection), style_(style), at_(at) {
        const auto point = projection.point(at);
        if (point)
            length_ = static_cast<float>(kLength * style.scale * projection.metresPerPixel(point->depth));
    }

    bool visible() const { return length_ > 0; }

    void vector(const Vec3& direction, const std::string& label, const Ink& ink) {
        const auto line = projection_.line(at_, at_ + length_ * direction);
        if (!line) return;
        const Vec2 along = line->to.at - line->from.at;
        const float pixels = glm::length(along);
        const Vec2 unit = pixels > 0 ? along / pixels : Vec2(0, -1);
        const Vec2 back = -9 * style_.scale * unit, side = 0.4F * Vec2(-back.y, back.x);
        sketch_.line(line->from.at, line->to.at, style_.ground, 4.6F * style_.scale);
        sketch_.line(line->from.at, line->to.at + 0.7F * back, ink, 2.4F * style_.scale);
        sketch_.fill({line->to.at, line->to.at + back + side, line->to.at + back - side}, ink);
        sketch_.labels.push_back({line->to.at + 10 * style_.scale * unit, label, ink,
                                  Vec2(0.5F - 0.5F * unit.x, 0.5F - 0.5F * unit.y)});
    }

    void arc(const Vec3& from, const Vec3& to, const Ink& ink) {
        constexpr int kSteps = 24;
        const double angle = angleBetween(from, to);
        if (angle < kLeastAngle || angle > kPiD - kLeastAngle) return;
        std::vector<Vec2> points;
        for (int i = 0; i <= kSteps; ++i) {
            const Vec3 direction = between(from, to, static_cast<float>(i) / kSteps);
            const auto point = projection_.point(at_ + kArc * length_ * direction);
            if (!point) return;
            points.push_back(point->at);
        }
        sketch_.paths.push_back({points, ink, 1.6F * style_.scale});
    }

    /// The tangent plane as a disc.
    void disc(const Vec3& normal, Ink ink) {
        constexpr int kSteps = 40;
        const Frame frame = Frame::around(normal);
        std::vector<Vec2> points;
        for (int i = 0; i < kSteps; ++i) {
            const float angle = 2 * kPi * static_cast<float>(i) / kSteps;
            const Vec3 out = std::cos(angle) * frame.tangent + std::sin(angle) * frame.bitangent;
            const auto point = projection_.point(at_ + kArc * length_ * out);
            if (!point) return;
            points.push_back(point->at);
        }
        ink.a = 0.22F;
        sketch_.fill(points, ink);
    }

private:
    Sketch& sketch_;
    const Projection& projection_;
    const RayStyle& style_;
    Vec3 at_;
    float length_ = 0;
};

Vec3 mirrored(const Vec3& direction, const Vec3& n) { return 2 * glm::dot(direction, n) * n - direction; }

std::string labelled(const char* name, const Vec3& direction, const Vec3& normal) {
    return fmt::format("{} {:.1f}°", name, degrees(angleBetween(direction, normal)));
}

}

std::optional<HitVectors> vectorsAt(const SampleRecord& record, int selectedRay) {
    if (selectedRay < 0 || selectedRay >= static_cast<int>(record.rays.size())) return std::nullopt;
    const auto at = [&](int ray) -> const RayRecord& { return record.rays[static_cast<std::size_t>(ray)]; };
    const bool shadow = at(selectedRay).kind == RayKind::Shadow;
    const int base = shadow ? at(selectedRay).parent : selectedRay;
    if (base < 0 || at(base).end != RayEnd::Hit) return std::nullopt;
    const HitRecord& hit = at(base).hit;
    HitVectors vectors;
    vectors.at = hit.position;
    vectors.n = hit.normal;
    vectors.v = -at(base).direction;
    for (const LampTerm& term : record.lamps) {
        const bool lit = term.ray == base && term.state == LampTerm::State::Lit;
        if (lit && !vectors.l && (!shadow || term.shadowRay == selectedRay)) vectors.l = term.wi;
    }
    const auto child = [&](RayKind kind) {
        return std::any_of(record.rays.begin(), record.rays.end(),
                           [&](const RayRecord& ray) { return ray.parent == base && ray.kind == kind; });
    };
    if (vectors.l)
        vectors.r = mirrored(*vectors.l, vectors.n);
    else if (child(RayKind::Reflection))
        vectors.r = mirrored(vectors.v, vectors.n);
    for (const RayRecord& ray : record.rays)
        if (ray.parent == base && ray.kind == RayKind::Refraction) vectors.t = ray.direction;
    return vectors;
}

void drawVectors(Sketch& sketch, const Projection& projection, const HitVectors& vectors,
                 const RayStyle& style) {
    VectorPainter painter(sketch, projection, style, vectors.at);
    if (!painter.visible()) return;
    const auto ink = [&](RayKind kind) { return style.kinds[static_cast<std::size_t>(kind)]; };
    const Ink normal = style.text, lamp = ink(RayKind::Shadow), mirror = ink(RayKind::Reflection),
              eye = ink(RayKind::Eye), through = ink(RayKind::Refraction);
    painter.disc(vectors.n, normal);
    painter.arc(vectors.n, vectors.v, eye);
    if (vectors.l) painter.arc(vectors.n, *vectors.l, lamp);
    if (vectors.r) painter.arc(vectors.n, *vectors.r, mirror);
    if (vectors.t) painter.arc(-vectors.n, *vectors.t, through);
    painter.vector(vectors.v, labelled("v", vectors.v, vectors.n), eye);
    if (vectors.l) painter.vector(*vectors.l, labelled("l", *vectors.l, vectors.n), lamp);
    if (vectors.r) painter.vector(*vectors.r, labelled("r", *vectors.r, vectors.n), mirror);
    if (vectors.t) painter.vector(*vectors.t, labelled("t", *vectors.t, -vectors.n), through);
    painter.vector(vectors.n, "n", normal);
}

}
