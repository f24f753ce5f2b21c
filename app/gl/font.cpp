#include "app/gl/font.h"

// font.S
extern "C" const std::byte eyeray_font_begin[];
extern "C" const std::byte eyeray_font_end[];

namespace eyeray {

std::span<const std::byte> fontBytes() { return {eyeray_font_begin, eyeray_font_end}; }

}
