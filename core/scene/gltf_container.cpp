#include "core/scene/gltf_container.h"

#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/scene/gltf_limits.h"

namespace eyeray {

namespace {

constexpr std::size_t kHeaderBytes = 12, kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942; // "JSON", "BIN\0"

/// A little-endian number; the caller has checked that it is there.
std::uint32_t numberAt(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<std::uint32_t>(bytes[offset + i]);
    return value;
}

bool startsWith(std::span<const std::byte> bytes, std::string_view text) {
    return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

std::string_view asText(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
    std::uint32_t kind;
    std::span<const std::byte> bytes;
    std::size_t end;
};

Chunk chunkAt(std::span<const std::byte> file, std::size_t offset, const std::string& where) {
    if (file.size() - offset < kChunkHeaderBytes)
        throw InputError{where, fmt::format("the chunk at byte {} has no whole header", offset),
                         "the file is damaged: export it again"};
    const std::size_t length = numberAt(file, offset), begin = offset + kChunkHeaderBytes;
    if (length > file.size() - begin)
        throw InputError{where,
                         fmt::format("the chunk at byte {} claims {} bytes, {} are left", offset, length,
                                     file.size() - begin),
                         "the file is damaged or cut off: export or copy it again"};
    return {numberAt(file, offset + 4), file.subspan(begin, length), begin + length};
}

GltfContainer openBinary(std::span<const std::byte> file, const std::string& where) {
    if (file.size() < kHeaderBytes)
        throw InputError{where, "ends inside its header", "the file is cut off: copy it again"};
    if (const std::uint32_t version = numberAt(file, 4); version != 2)
        throw InputError{where, fmt::format("is binary glTF version {}", version), "export it as glTF 2.0"};
    const std::size_t length = numberAt(file, 8);
    if (length > file.size() || length < kHeaderBytes)
        throw InputError{where, fmt::format("claims {} bytes, has {}", length, file.size()),
                         "the file is damaged or cut off: export or copy it again"};
    file = file.first(length);

    const Chunk json = chunkAt(file, kHeaderBytes, where);
    if (json.kind != kJsonChunk)
        throw InputError{where, "its first chunk is not JSON", "export it again as glTF 2.0"};
    GltfContainer result{asText(json.bytes), {}};
    if (json.end < file.size()) {
        const Chunk binary = chunkAt(file, json.end, where);
        if (binary.kind == kBinaryChunk) result.binary = binary.bytes; // other kinds are extensions
    }
    return result;
}

/// Counts brackets outside of strings; says nothing about whether the rest is JSON.
void checkBrackets(std::string_view json, const std::string& where) {
    int depth = 0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < json.size(); ++i, ++outside) {
        const char c = json[i];
        if (c == '"') {
            for (++i; i < json.size() && json[i] != '"'; ++i)
                if (json[i] == '\\') ++i;
        } else if (c == '[' || c == '{') {
            if (++depth > limits::kJsonDepth)
                throw InputError{
                    where, fmt::format("nests JSON deeper than {} levels at byte {}", limits::kJsonDepth, i),
                    "no scene needs that: export it again"};
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    if (outside > limits::kJsonBytes)
        throw InputError{where, fmt::format("has more than {} MB of JSON", limits::kJsonBytes >> 20U),
                         "keep big data in buffers, or split the scene"};
}

}

GltfContainer openContainer(std::span<const std::byte> file, const std::string& where) {
    if (file.empty()) throw InputError{where, "is empty", "choose a .gltf or .glb file"};
    if (file.size() > limits::kFileBytes)
        throw InputError{where, fmt::format("is larger than {} MB", limits::kFileBytes >> 20U),
                         "split the scene"};
    const GltfContainer result =
        startsWith(file, "glTF") ? openBinary(file, where) : GltfContainer{asText(file), {}};
    checkBrackets(result.json, where);
    return result;
}

}
