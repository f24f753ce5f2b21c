#pragma once
// The program's font, part of the program.

#include <cstddef>
#include <span>

namespace eyeray {

/// The TrueType file of DejaVu Sans.
std::span<const std::byte> fontBytes();

}
