#pragma once
// Numbers out of buffers.

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/gltf_document.h"

namespace eyeray {

/// The bytes of a buffer view. Throws InputError naming `where` if it does not exist or reaches out of its
/// buffer.
std::span<const std::byte> viewBytes(const GltfDocument&, int bufferView, const std::string& where);

/// Number of elements of an accessor, which may not be backed by any bytes. Throws InputError naming `where`
/// if it does not exist.
std::size_t accessorCount(const GltfDocument&, int accessor, const std::string& where);

/// All elements of an accessor whose number of components is in `allowed`, one after the other: floats as
/// they are, normalised integers in [0, 1] or [−1, 1], others by their value; sparse elements put in their
/// places. Every range is checked. Throws InputError.
struct FloatElements {
    int components;
    std::vector<float> values;
};
FloatElements readFloats(const GltfDocument&, int accessor, std::initializer_list<int> allowed);

/// All elements of a scalar accessor of unsigned integers. Throws InputError.
std::vector<std::uint32_t> readIndices(const GltfDocument&, int accessor);

}
