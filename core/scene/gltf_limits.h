#pragma once
// What a scene file may ask for. A file beyond these is refused with a line that says which limit it breaks,
// before the memory for it is taken.

#include <cstddef>

namespace eyeray::limits {

inline constexpr std::size_t kFileBytes = std::size_t{512} << 20;
inline constexpr std::size_t kJsonBytes = std::size_t{64}
                                          << 20; // outside of strings, so data URIs may be longer
inline constexpr int kJsonDepth = 64;
inline constexpr std::size_t kBufferBytes = std::size_t{1} << 30; // all buffers together

inline constexpr std::size_t kNodes = 100'000;
inline constexpr int kNodeDepth = 512;
inline constexpr std::size_t kObjects = 1'000'000;
inline constexpr std::size_t kTriangles = 20'000'000;
inline constexpr std::size_t kVertices = 3 * kTriangles;        // of one mesh
inline constexpr std::size_t kMeshBytes = std::size_t{2} << 30; // all meshes together

inline constexpr std::size_t kImages = 256;
inline constexpr std::size_t kImageBytes = std::size_t{1} << 30; // decoded, all images together

inline constexpr double kNumber = 1e15; // largest coordinate, colour or size
inline constexpr std::size_t kNameBytes = 200;
inline constexpr std::size_t kReportLines = 200;

}
