#include "core/scene/gltf_accessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_limits.h"

namespace eyeray {

namespace {

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
    throw InputError{where, what, "export the file again"};
}

/// Calls f with a value of the C++ type of a component. Throws for a type that glTF does not have.
template <class F>
auto withComponentType(int componentType, const std::string& where, F&& f) {
    switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return f(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return f(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return f(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return f(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return f(std::uint32_t{});
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return f(float{});
    default:
        refuse(where, fmt::format("componentType {} does not exist", componentType));
    }
}

std::size_t componentBytes(int componentType, const std::string& where) {
    return withComponentType(componentType, where, [](auto type) { return sizeof(type); });
}

/// Equally spaced elements within the bytes of a view.
struct Elements {
    const std::byte* first = nullptr;
    std::size_t count = 0, stride = 0;

    template <class T>
    T at(std::size_t element, std::size_t component) const {
        T value;
        std::memcpy(&value, first + element * stride + component * sizeof(T), sizeof(T));
        return value;
    }
};

/// Throws unless `count` elements of `size` bytes lie in the view.
Elements elementsIn(std::span<const std::byte> bytes, std::size_t offset, std::size_t count, std::size_t size,
                    std::size_t stride, const std::string& where) {
    if (stride < size) refuse(where, fmt::format("elements of {} bytes lie {} bytes apart", size, stride));
    const bool fits =
        offset <= bytes.size() && (count == 0 || (size <= bytes.size() - offset &&
                                                  count - 1 <= (bytes.size() - offset - size) / stride));
    if (!fits)
        refuse(where, fmt::format("{} elements of {} bytes do not fit into {} bytes of its bufferView", count,
                                  size, bytes.size()));
    return {bytes.data() + offset, count, stride};
}

struct AccessorShape {
    std::size_t components, bytes;
};

Elements baseElements(const GltfDocument& document, const tinygltf::Accessor& accessor,
                      const AccessorShape& shape, const std::string& where) {
    const auto bytes = viewBytes(document, accessor.bufferView, where);
    const std::size_t stride = document.model.bufferViews[accessor.bufferView].byteStride;
    return elementsIn(bytes, accessor.byteOffset, accessor.count, shape.bytes,
                      stride > 0 ? stride : shape.bytes, where);
}

struct SparseElements {
    std::vector<std::uint32_t> places;
    Elements values;
};

SparseElements sparseElements(const GltfDocument& document, const tinygltf::Accessor& accessor,
                              const AccessorShape& shape, const std::string& accessorWhere) {
    const auto& sparse = accessor.sparse;
    const std::string where = accessorWhere + ".sparse";
    const auto count = static_cast<std::size_t>(sparse.count);
    const std::size_t indexBytes = componentBytes(sparse.indices.componentType, where);
    const Elements indices =
        elementsIn(viewBytes(document, sparse.indices.bufferView, where),
                   static_cast<std::size_t>(sparse.indices.byteOffset), count, indexBytes, indexBytes, where);
    SparseElements result;
    result.values = elementsIn(viewBytes(document, sparse.values.bufferView, where),
                               static_cast<std::size_t>(sparse.values.byteOffset), count, shape.bytes,
                               shape.bytes, where);
    withComponentType(sparse.indices.componentType, where, [&](auto type) {
        using T = decltype(type);
        if constexpr (!std::is_unsigned_v<T>)
            refuse(where, "its indices are not unsigned integers");
        else
            for (std::size_t i = 0; i < count; ++i) result.places.push_back(indices.at<T>(i, 0));
    });
    for (const std::uint32_t place : result.places)
        if (place >= accessor.count)
            refuse(where, fmt::format("replaces element {} of {}", place, accessor.count));
    return result;
}

const tinygltf::Accessor& accessorAt(const GltfDocument& document, int accessor, const std::string& where) {
    const auto& accessors = document.model.accessors;
    if (accessor < 0 || static_cast<std::size_t>(accessor) >= accessors.size())
        refuse(where, fmt::format("accessor {} does not exist", accessor));
    return accessors[accessor];
}

AccessorShape shapeOf(const tinygltf::Accessor& accessor, std::initializer_list<int> allowed,
                      const std::string& where) {
    const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    const bool vector = accessor.type != TINYGLTF_TYPE_MAT2; // of four components, as a VEC4 is
    if (!vector || std::find(allowed.begin(), allowed.end(), components) == allowed.end())
        refuse(where, fmt::format("has {} components, which does not fit its use", components));
    if (accessor.count > limits::kVertices) refuse(where, fmt::format("has {} elements", accessor.count));
    const auto count = static_cast<std::size_t>(components);
    return {count, count * componentBytes(accessor.componentType, where)};
}

/// glTF 2.0, section 3.6.2.2: how normalised integers stand for reals.
template <class T>
float toFloat(T value, bool normalized) {
    if constexpr (std::is_floating_point_v<T>) {
        return value;
    } else {
        if (!normalized) return static_cast<float>(value);
        constexpr float kMost = static_cast<float>(std::numeric_limits<T>::max());
        return std::max(static_cast<float>(value) / kMost, -1.0F);
    }
}

}

std::span<const std::byte> viewBytes(const GltfDocument& document, int bufferView, const std::string& where) {
    const auto& views = document.model.bufferViews;
    if (bufferView < 0 || static_cast<std::size_t>(bufferView) >= views.size())
        refuse(where, fmt::format("bufferView {} does not exist", bufferView));
    const tinygltf::BufferView& view = views[bufferView];
    const std::string viewWhere = document.at("bufferViews", static_cast<std::size_t>(bufferView));
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= document.buffers.size())
        refuse(viewWhere, fmt::format("buffer {} does not exist", view.buffer));
    const auto buffer = document.buffers[view.buffer];
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
        refuse(viewWhere, fmt::format("{} bytes from byte {} do not lie in a buffer of {} bytes",
                                      view.byteLength, view.byteOffset, buffer.size()));
    return buffer.subspan(view.byteOffset, view.byteLength);
}

std::size_t accessorCount(const GltfDocument& document, int accessor, const std::string& where) {
    return accessorAt(document, accessor, where).count;
}

FloatElements readFloats(const GltfDocument& document, int index, std::initializer_list<int> allowed) {
    const std::string where = document.at("accessors", static_cast<std::size_t>(index));
    const tinygltf::Accessor& accessor = accessorAt(document, index, where);
    const AccessorShape shape = shapeOf(accessor, allowed, where);

    FloatElements result{static_cast<int>(shape.components),
                         std::vector<float>(accessor.count * shape.components, 0.0F)};
    const auto copy = [&](const Elements& from, auto placeOf) {
        withComponentType(accessor.componentType, where, [&](auto type) {
            using T = decltype(type);
            for (std::size_t i = 0; i < from.count; ++i)
                for (std::size_t c = 0; c < shape.components; ++c)
                    result.values[placeOf(i) * shape.components + c] =
                        toFloat(from.at<T>(i, c), accessor.normalized);
        });
    };
    if (accessor.bufferView >= 0)
        copy(baseElements(document, accessor, shape, where), [](std::size_t i) { return i; });
    if (accessor.sparse.isSparse) {
        const SparseElements sparse = sparseElements(document, accessor, shape, where);
        copy(sparse.values, [&](std::size_t i) { return std::size_t{sparse.places[i]}; });
    }
    return result;
}

std::vector<std::uint32_t> readIndices(const GltfDocument& document, int index) {
    const std::string where = document.at("accessors", static_cast<std::size_t>(index));
    const tinygltf::Accessor& accessor = accessorAt(document, index, where);
    const AccessorShape shape = shapeOf(accessor, {1}, where);
    std::vector<std::uint32_t> result(accessor.count, 0U);
    withComponentType(accessor.componentType, where, [&](auto type) {
        using T = decltype(type);
        if constexpr (!std::is_unsigned_v<T>) {
            refuse(where, "indices are not unsigned integers");
        } else {
            if (accessor.bufferView >= 0) {
                const Elements base = baseElements(document, accessor, shape, where);
                for (std::size_t i = 0; i < base.count; ++i) result[i] = base.at<T>(i, 0);
            }
            if (accessor.sparse.isSparse) {
                const SparseElements sparse = sparseElements(document, accessor, shape, where);
                for (std::size_t i = 0; i < sparse.places.size(); ++i)
                    result[sparse.places[i]] = sparse.values.at<T>(i, 0);
            }
        }
    });
    return result;
}

}
