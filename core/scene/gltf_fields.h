#pragma once
// Typed reading of extras and extensions.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <tiny_gltf.h>

#include "core/base/math.h"
#include "core/scene/gltf_limits.h"
#include "core/scene/gltf_notes.h"

namespace eyeray {

/// Where a number must lie.
struct Range {
    double lo = -limits::kNumber, hi = limits::kNumber;
};
inline constexpr Range kUnit{0, 1}, kPositive{1e-15, limits::kNumber}, kNotNegative{0, limits::kNumber};

/// The members of one JSON object. Every question has a default for members that are not there; a member of
/// another type throws InputError, a number out of range is moved into it with a note.
class GltfFields {
public:
    /// `object` may be null: then every answer is the default.
    GltfFields(const tinygltf::Value* object, std::string where, GltfNotes& notes)
        : object_(object), where_(std::move(where)), notes_(&notes) {}

    bool present() const { return object_ != nullptr; }
    bool has(const std::string& key) const { return object_ != nullptr && object_->Has(key); }
    const std::string& where() const { return where_; }

    double number(const std::string& key, double fallback, Range = {});
    float real(const std::string& key, float fallback, Range = {});
    int whole(const std::string& key, int fallback, int lo, int hi);
    bool flag(const std::string& key, bool fallback);
    std::string text(const std::string& key, const std::string& fallback);
    Color color(const std::string& key, const Color& fallback, Range = kNotNegative);
    Vec2 pair(const std::string& key, const Vec2& fallback);

    /// An index into something of the given size. Throws InputError if it lies outside.
    std::optional<int> index(const std::string& key, std::size_t size);
    std::vector<int> indices(const std::string& key, std::size_t size);
    std::vector<std::string> texts(const std::string& key);
    GltfFields child(const std::string& key);
    std::vector<GltfFields> children(const std::string& key);

    /// Notes every member that nobody asked for.
    void reportUnread() const;

    /// Throws InputError about this object.
    [[noreturn]] void refuse(const std::string& what) const;

private:
    const tinygltf::Value* find(const std::string& key);
    const tinygltf::Value::Array* array(const std::string& key);
    std::vector<double> numbers(const std::string& key, std::size_t count, Range);
    double inRange(const tinygltf::Value&, const std::string& key, Range) const;
    int indexFrom(const tinygltf::Value&, const std::string& key, std::size_t size) const;

    const tinygltf::Value* object_;
    std::string where_;
    GltfNotes* notes_;
    std::set<std::string> read_;
};

/// What `extras.eyeray` says of a part of the file; `where` names the part.
GltfFields eyerayExtras(const tinygltf::Value& extras, const std::string& where, GltfNotes&);

/// The members of one extension of a part of the file.
GltfFields extensionFields(const tinygltf::ExtensionMap&, const std::string& name, const std::string& where,
                           GltfNotes&);

}
