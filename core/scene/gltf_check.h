#pragma once
// Whether the JSON of a scene file has the form that glTF asks for.

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/scene/gltf_notes.h"

namespace eyeray {

/// Throws InputError unless this is glTF 2.x that needs no extension we lack, its sections are lists of
/// objects within the limits, and whatever points to something is a whole number, not negative. Whole numbers
/// of more than 32 bits that point to nothing become real ones, for tinygltf would cut them. Unknown
/// extensions are noted.
void checkDocument(nlohmann::json& document, const std::string& where, GltfNotes&);

}
