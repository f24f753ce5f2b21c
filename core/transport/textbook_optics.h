#pragma once
// Mirror and glass as slides have them, each with what goes wrong. Directions point away from the surface and
// are unit, the normal is on wo's side, `eta` = η of wo's side / η of the other side, as in optics.h.

#include <cmath>

#include "core/geometry/textbook_ray.h"

namespace eyeray::textbook {

/// 2(n·wo)n + wo. F30: the sign that slides lose; |r| is up to 3 and the ray goes back along wo.
template <class T>
Vector<T> reflected(const Vector<T>& wo, const Vector<T>& normal) {
    return 2 * glm::dot(normal, wo) * normal + wo;
}

/// Refracted direction without a test for total reflection. F27: the root of a negative number is NaN. F29:
/// with 1/ior for `eta` on the way out too, a ray leaves glass where it should be reflected.
template <class T>
Vector<T> refracted(const Vector<T>& wo, const Vector<T>& normal, T eta) {
    const T cosine = glm::dot(normal, wo);
    return -eta * wo + (eta * cosine - std::sqrt(1 - eta * eta * (1 - cosine * cosine))) * normal;
}

/// F0 + (1 − F0)(1 − cosine)⁵ with the cosine of wo, also inside the denser medium. C. Schlick 1994, "An
/// Inexpensive BRDF Model for Physically-based Rendering". F28: −21.5 % at 60°, and on the way out of glass a
/// sixth of the truth; total reflection is never reached.
template <class T>
T schlick(T cosine, T eta) {
    const T root = (1 - eta) / (1 + eta), f0 = root * root;
    return f0 + (1 - f0) * std::pow(1 - cosine, T(5));
}

/// 2(n·wo)n − wo about a normal that shading has bent. F35: where that leans away from the surface's own, the
/// ray goes inside.
template <class T>
Vector<T> mirroredAbout(const Vector<T>& bentNormal, const Vector<T>& wo) {
    return 2 * glm::dot(bentNormal, wo) * bentNormal - wo;
}

/// (r·wo)ⁿ. F33: without the test whether the lamp is behind the surface it shines through; and the power of
/// a negative number is NaN.
template <class T>
T highlight(const Vector<T>& wo, const Vector<T>& normal, const Vector<T>& wi, T shininess) {
    return std::pow(glm::dot(mirroredAbout(normal, wi), wo), shininess);
}

}
