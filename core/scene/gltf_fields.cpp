#include "core/scene/gltf_fields.h"

#include <fmt/format.h>

#include "core/base/errors.h"

namespace eyeray {

using tinygltf::Value;

const Value* GltfFields::find(const std::string& key) {
    if (!has(key)) return nullptr;
    read_.insert(key);
    return &object_->Get(key);
}

void GltfFields::refuse(const std::string& what) const {
    throw InputError{where_, what, "correct it, or export the file again"};
}

double GltfFields::inRange(const Value& value, const std::string& key, Range range) const {
    if (!value.IsNumber()) refuse(key + " is not a number");
    return clamped(value.GetNumberAsDouble(), range.lo, range.hi, where_ + "." + key, *notes_);
}

double GltfFields::number(const std::string& key, double fallback, Range range) {
    const Value* const value = find(key);
    return value ? inRange(*value, key, range) : fallback;
}

float GltfFields::real(const std::string& key, float fallback, Range range) {
    return static_cast<float>(number(key, static_cast<double>(fallback), range));
}

int GltfFields::whole(const std::string& key, int fallback, int lo, int hi) {
    const Value* const value = find(key);
    if (!value) return fallback;
    if (!value->IsInt()) refuse(key + " is not a whole number");
    return static_cast<int>(inRange(*value, key, {static_cast<double>(lo), static_cast<double>(hi)}));
}

bool GltfFields::flag(const std::string& key, bool fallback) {
    const Value* const value = find(key);
    if (value && !value->IsBool()) refuse(key + " is not true or false");
    return value ? value->Get<bool>() : fallback;
}

std::string GltfFields::text(const std::string& key, const std::string& fallback) {
    const Value* const value = find(key);
    if (value && !value->IsString()) refuse(key + " is not a text");
    return value ? value->Get<std::string>() : fallback;
}

const Value::Array* GltfFields::array(const std::string& key) {
    const Value* const value = find(key);
    if (value && !value->IsArray()) refuse(key + " is not a list");
    return value ? &value->Get<Value::Array>() : nullptr;
}

std::vector<double> GltfFields::numbers(const std::string& key, std::size_t count, Range range) {
    std::vector<double> result;
    if (const auto* const values = array(key)) {
        if (values->size() != count) refuse(fmt::format("{} has not {} numbers", key, count));
        for (const Value& value : *values) result.push_back(inRange(value, key, range));
    }
    return result;
}

Color GltfFields::color(const std::string& key, const Color& fallback, Range range) {
    const auto values = numbers(key, 3, range);
    return values.empty() ? fallback : Color(values[0], values[1], values[2]);
}

Vec2 GltfFields::pair(const std::string& key, const Vec2& fallback) {
    const auto values = numbers(key, 2, {});
    return values.empty() ? fallback : Vec2(values[0], values[1]);
}

int GltfFields::indexFrom(const Value& value, const std::string& key, std::size_t size) const {
    if (!value.IsInt()) refuse(key + " is not an index");
    const int index = value.Get<int>();
    if (index < 0 || static_cast<std::size_t>(index) >= size)
        refuse(fmt::format("{} {} does not exist, there are {}", key, index, size));
    return index;
}

std::optional<int> GltfFields::index(const std::string& key, std::size_t size) {
    const Value* const value = find(key);
    if (!value) return std::nullopt;
    return indexFrom(*value, key, size);
}

std::vector<int> GltfFields::indices(const std::string& key, std::size_t size) {
    std::vector<int> result;
    if (const auto* const values = array(key))
        for (const Value& value : *values) result.push_back(indexFrom(value, key, size));
    return result;
}

std::vector<std::string> GltfFields::texts(const std::string& key) {
    std::vector<std::string> result;
    if (const auto* const values = array(key))
        for (const Value& value : *values) {
            if (!value.IsString()) refuse(key + " is not a list of texts");
            result.push_back(value.Get<std::string>());
        }
    return result;
}

GltfFields GltfFields::child(const std::string& key) {
    const Value* const value = find(key);
    if (value && !value->IsObject()) refuse(key + " is not an object");
    return {value, where_ + "." + key, *notes_};
}

std::vector<GltfFields> GltfFields::children(const std::string& key) {
    std::vector<GltfFields> result;
    if (const auto* const values = array(key))
        for (std::size_t i = 0; i < values->size(); ++i) {
            if (!(*values)[i].IsObject()) refuse(fmt::format("{}[{}] is not an object", key, i));
            result.emplace_back(&(*values)[i], fmt::format("{}.{}[{}]", where_, key, i), *notes_);
        }
    return result;
}

void GltfFields::reportUnread() const {
    if (!object_) return;
    for (const std::string& key : object_->Keys())
        if (!read_.contains(key)) notes_->ignored(fmt::format("{}: {} is not known", where_, key));
}

GltfFields eyerayExtras(const Value& extras, const std::string& where, GltfNotes& notes) {
    const bool there = extras.IsObject() && extras.Has("eyeray") && extras.Get("eyeray").IsObject();
    return {there ? &extras.Get("eyeray") : nullptr, where + ".extras.eyeray", notes};
}

GltfFields extensionFields(const tinygltf::ExtensionMap& extensions, const std::string& name,
                           const std::string& where, GltfNotes& notes) {
    const auto found = extensions.find(name);
    const bool there = found != extensions.end() && found->second.IsObject();
    return {there ? &found->second : nullptr, where + "." + name, notes};
}

}
