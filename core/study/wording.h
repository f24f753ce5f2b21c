#pragma once
// The words for what happened to a ray, the same in every view.

#include <cstdint>
#include <string>
#include <string_view>

#include "core/scene/scene.h"
#include "core/transport/recorder.h"

namespace eyeray {

/// Names of parts of the scene, by their number if they have none or are not there: a record may be of the
/// scene before an edit, until the picture of the new one is there. Object −1 is "the surface of a lamp".
std::string objectName(const Scene&, int object);
std::string lampName(const Scene&, int light);

/// What a ray met: "mirror ball", "nothing hit", "reaches lamp", "blocked before lamp".
std::string meeting(const Scene&, const RayRecord&);

/// How a ray ended, in one word: "hit", "background", "unblocked", "blocked".
std::string_view name(RayEnd);

/// Why a ray was not traced.
std::string_view reasonText(UntracedRay::Reason);
inline constexpr std::string_view kTotalReflectionText = "total internal reflection";

/// A share or weight by its largest channel, with two digits that count.
std::string weightText(const Color& weight);

/// A length in metres, with four digits.
std::string metresText(float t);

/// "r g b", four digits each.
std::string colorText(const Color&);

/// The same in three digits, as one number for a grey: "0.5", "(0.5 0.2 0.1)".
std::string amountText(const Color&);

/// A count with its digits in groups of three: "1 234 567".
std::string countText(std::uint64_t count);

}
