#pragma once
// Textures and images, read when a material asks for them.

#include <map>
#include <optional>

#include "core/scene/gltf_import.h"

namespace eyeray {

/// Makes Scene::textures and Scene::images. What cannot be read or decoded is left out with a note, and the
/// surface shows without it.
class GltfTextures {
public:
    explicit GltfTextures(GltfImport& context) : context_(context) {}

    /// Where a material reads which texture; `info` is a texture info of glTF core. Throws InputError if the
    /// texture does not exist.
    TextureRef reference(const tinygltf::TextureInfo& info, const std::string& where);

    /// The same from a member of an extension.
    TextureRef reference(GltfFields& extension, const std::string& key);

    /// The checkerboard of extras.eyeray.
    TextureRef checker(GltfFields& fields);

private:
    TextureRef placed(int texture, int uvSet, GltfFields transform);
    int textureOf(int index, const std::string& where);
    std::optional<int> imageOf(int index, const std::string& where);
    Image decode(int index, const std::string& where) const;

    GltfImport& context_;
    std::map<int, int> textures_;              // of the file to Scene's, −1 if it cannot be shown
    std::map<int, std::optional<int>> images_; // likewise
    std::size_t decodedBytes_ = 0;
};

}
