#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/codecs.h"
#include "core/image/png_errors.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostDeflateGives = 1032; // bytes out of one byte in: 258 out of 2 bits
constexpr png_uint_32 kMostTextChunks = 100;
constexpr png_alloc_size_t kMostTextBytes = 1'000'000;
constexpr std::array<png_byte, 15> kTextChunks{'t', 'E', 'X', 't', 0,   'z', 'T', 'X',
                                               't', 0,   'i', 'T', 'X', 't', 0};

/// libpng over bytes in memory. The functions with setjmp own nothing, for a longjmp ends them.
class PngReader {
public:
    PngReader(std::span<const std::byte> bytes, const std::string& where)
        : bytes_(bytes), rest_(bytes), where_(where),
          png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message_, onPngError, onPngWarning)) {
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, &rest_, onRead);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX); // our own limits have the better message
        // Passes over all chunks but those that make pixels.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    DecodedImage readPicture() {
        png_set_chunk_malloc_max(png_, 0);
        check(readHeader());
        const png_uint_32 width = png_get_image_width(png_, info_),
                          height = png_get_image_height(png_, info_);
        checkPictureSize(width, height, where_);
        if (png_get_rowbytes(png_, info_) * height > kMostDeflateGives * bytes_.size())
            throw InputError{
                where_, fmt::format("is cut short: {} bytes for {}x{} pixels", bytes_.size(), width, height),
                "export or copy it again"};
        const bool hasAlpha = (png_get_color_type(png_, info_) & PNG_COLOR_MASK_ALPHA) != 0 ||
                              png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;

        check(askForRgba());
        DecodedImage image{{static_cast<int>(width), static_cast<int>(height)}, hasAlpha};
        ENSURE(png_get_rowbytes(png_, info_) == width * sizeof(Rgba8));
        std::vector<png_bytep> rows(height);
        for (png_uint_32 y = 0; y < height; ++y)
            rows[y] = reinterpret_cast<png_bytep>(&image.pixels.at(0, static_cast<int>(y)));
        check(readRows(rows.data()));
        return image;
    }

    std::span<const png_text> readTexts() {
        png_set_chunk_malloc_max(png_, kMostTextBytes);
        png_set_chunk_cache_max(png_, kMostTextChunks);
        // Else libpng only warns of a chunk over the limit, and takes memory for all that it claims to hold.
        png_set_benign_errors(png_, 0);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_AS_DEFAULT, kTextChunks.data(), 3);
        check(readHeader());
        png_textp texts = nullptr;
        const int count = png_get_text(png_, info_, &texts, nullptr);
        return {texts, static_cast<std::size_t>(count)};
    }

private:
    void check(bool done) const {
        if (!done)
            throw InputError{where_, std::string("is a damaged PNG: ") + message_.data(),
                             "export or copy it again"};
    }

    bool readHeader() {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_read_info(png_, info_);
        return true;
    }

    bool askForRgba() {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_set_expand(png_);
        png_set_scale_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_add_alpha(png_, 255, PNG_FILLER_AFTER);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }

    bool readRows(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

    static void onRead(png_structp png, png_bytep into, std::size_t size) {
        auto& rest = *static_cast<std::span<const std::byte>*>(png_get_io_ptr(png));
        if (size > rest.size()) png_error(png, "it is cut short");
        std::memcpy(into, rest.data(), size);
        rest = rest.subspan(size);
    }

    std::span<const std::byte> bytes_, rest_;
    const std::string& where_;
    PngMessage message_{};
    png_structp png_;
    png_infop info_ = nullptr;
};

std::string utf8FromLatin1(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xC0U | code >> 6U);
            result += static_cast<char>(0x80U | (code & 0x3FU));
        }
    }
    return result;
}

}

DecodedImage decodePng(std::span<const std::byte> bytes, const std::string& where) {
    return PngReader(bytes, where).readPicture();
}

std::map<std::string, std::string> readPngText(std::span<const std::byte> bytes, const std::string& where) {
    PngReader reader(bytes, where);
    std::map<std::string, std::string> result;
    for (const png_text& text : reader.readTexts()) {
        const bool international = text.compression >= PNG_ITXT_COMPRESSION_NONE;
        result.emplace(utf8FromLatin1(text.key), international ? text.text : utf8FromLatin1(text.text));
    }
    return result;
}

}
