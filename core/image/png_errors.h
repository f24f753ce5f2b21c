#pragma once
// How we hear of libpng's errors. libpng is C and leaves by longjmp: what stands between setjmp and the call
// that fails must own nothing, and no exception may pass through libpng.

#include <array>
#include <cstdio>

#include <png.h>

namespace eyeray {

/// Room for what libpng said last; give it to png_create_*_struct as the error pointer.
using PngMessage = std::array<char, 200>;

[[noreturn]] inline void onPngError(png_structp png, png_const_charp message) {
    auto& kept = *static_cast<PngMessage*>(png_get_error_ptr(png));
    std::snprintf(kept.data(), kept.size(), "%s", message);
    png_longjmp(png, 1);
}

inline void onPngWarning(png_structp, png_const_charp) {} // none is worth a line on the terminal

}
