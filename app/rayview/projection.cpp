#include "app/rayview/projection.h"

namespace eyeray {
namespace {

/// Rigid map from coordinates around the origin to right, up and backward of the eye.
DMat4 viewMatrix(const CameraAxes& axes, const DVec3& eye) {
    const DMat3 rotation = glm::transpose(DMat3(axes.right, axes.up, axes.backward));
    DMat4 view(rotation);
    view[3] = DVec4(-(rotation * eye), 1);
    return view;
}

DMat4 perspective(double halfWidth, double halfHeight, double nearest, double farthest) {
    DMat4 m(0);
    m[0][0] = 1 / halfWidth;
    m[1][1] = 1 / halfHeight;
    m[2][2] = -(farthest + nearest) / (farthest - nearest);
    m[2][3] = -1;
    m[3][2] = -2 * farthest * nearest / (farthest - nearest);
    return m;
}

}

ScreenPoint ScreenLine::at(float share) const {
    const float inverse = (1 - share) / from.depth + share / to.depth;
    return {from.at + share * (to.at - from.at), 1 / inverse};
}

Projection::Projection(const Camera& camera, const DVec3& origin, int width, int height, double nearest,
                       double farthest)
    : axes_(axesOf(camera)), eye_(camera.eye - origin), width_(width), height_(height), nearest_(nearest),
      farthest_(farthest) {
    const DVec2 half = imagePlaneHalfExtents(camera.verticalFov, static_cast<double>(width) / height);
    halfHeight_ = half.y;
    clip_ = perspective(half.x, half.y, nearest, farthest) * viewMatrix(axes_, eye_);
}

DVec3 Projection::inEye(const DVec3& p) const {
    const DVec3 to = p - eye_;
    return {glm::dot(to, axes_.right), glm::dot(to, axes_.up), -glm::dot(to, axes_.backward)};
}

ScreenPoint Projection::onScreen(const DVec3& p) const {
    const double pixels = 0.5 * height_ / (halfHeight_ * p.z);
    return {Vec2(0.5 * width_ + pixels * p.x, 0.5 * height_ - pixels * p.y), static_cast<float>(p.z)};
}

std::optional<ScreenPoint> Projection::point(const DVec3& p) const {
    const DVec3 q = inEye(p);
    if (!(q.z >= nearest_)) return std::nullopt;
    return onScreen(q);
}

std::optional<ScreenLine> Projection::line(const DVec3& from, const DVec3& to) const {
    DVec3 a = inEye(from), b = inEye(to);
    if (!(a.z >= nearest_ || b.z >= nearest_)) return std::nullopt;
    const auto cut = [&](const DVec3& behind, const DVec3& before) {
        return behind + (before - behind) * ((nearest_ - behind.z) / (before.z - behind.z));
    };
    if (a.z < nearest_) a = cut(a, b);
    if (b.z < nearest_) b = cut(b, a);
    return ScreenLine{onScreen(a), onScreen(b)};
}

float Projection::distance(float depth) const {
    return static_cast<float>(nearest_ * farthest_ / (farthest_ - depth * (farthest_ - nearest_)));
}

}
