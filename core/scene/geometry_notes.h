#pragma once
// What of a scene's geometry cannot be shown right by any tracer, and is better told.

#include <stop_token>

#include "core/scene/gltf_notes.h"

namespace eyeray {

/// Notes objects whose faces lie in the same place, where rounding decides which of them is seen, and
/// transparent meshes that are not closed, so that rays enter them and never leave. Scenes of
/// more than 200,000 triangles are not looked at for the first, nor pairs beyond the first 64 whose boxes
/// meet; meshes of more than that are not for the second.
void noteGeometry(const Scene&, GltfNotes&, const std::stop_token&);

}
