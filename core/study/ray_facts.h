#pragma once
// What can be read off a record about one ray.

#include "core/study/family.h"

namespace eyeray {

/// Degrees between the ray and the normal where it hits, 0 to 90; 0 if it hits nothing.
float incidenceDegrees(const RayRecord&);

/// Of the pixel's colour, what this ray brings, and all rays beyond it: weight · radiance.
Color contribution(const RayRecord&);

/// What a hit sends on, whether it was traced or not: kr and kt at this angle, black where there is none.
struct SharesAtHit {
    Color reflected{0}, refracted{0};
    bool totalReflection = false;
    float eta = 1; // of the ray's side / of the other side, where light goes on through glass
};
SharesAtHit sharesAtHit(const SampleRecord&, const Family&, int ray);

}
