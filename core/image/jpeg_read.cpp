#include <array>
#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>
// After jpeglib.h, which it needs.
#include <jerror.h>

#include "core/base/errors.h"
#include "core/image/codecs.h"

namespace eyeray {
namespace {

constexpr int kMostScans = 100; // encoders make about ten; thousands keep a decoder busy for minutes

/// libjpeg over bytes in memory. The functions with setjmp own nothing, for a longjmp ends them.
class JpegReader {
public:
    JpegReader(std::span<const std::byte> bytes, const std::string& where) : bytes_(bytes), where_(where) {
        decoder_.err = jpeg_std_error(&errors_.manager);
        errors_.manager.error_exit = giveUp;
        errors_.manager.emit_message = onMessage;
        progress_.progress_monitor = onProgress;
    }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&decoder_); }

    DecodedImage readPicture() {
        check(readHeader());
        checkPictureSize(decoder_.image_width, decoder_.image_height, where_);
        if (decoder_.jpeg_color_space == JCS_CMYK || decoder_.jpeg_color_space == JCS_YCCK)
            throw InputError{where_, "is a JPEG in CMYK, the colors of printing", "save it as RGB"};
        // No browser reads these, and at a cut they go on for as many zeros as the picture is large.
        if (decoder_.arith_code)
            throw InputError{where_, "is a JPEG with arithmetic coding",
                             "save it with Huffman coding or as PNG"};
        DecodedImage image{{static_cast<int>(decoder_.image_width), static_cast<int>(decoder_.image_height)},
                           false};
        check(readRows(image.pixels));
        return image;
    }

private:
    struct Errors {
        jpeg_error_mgr manager; // first, so that libjpeg's pointer to it leads here
        jmp_buf wayOut;
        std::array<char, JMSG_LENGTH_MAX> message;
    };

    void check(bool done) const {
        if (!done)
            throw InputError{where_, std::string("is a damaged JPEG: ") + errors_.message.data(),
                             "export or copy it again"};
    }

    bool readHeader() {
        if (setjmp(errors_.wayOut)) return false;
        jpeg_create_decompress(&decoder_);
        decoder_.progress = &progress_;
        jpeg_mem_src(&decoder_, reinterpret_cast<const unsigned char*>(bytes_.data()), bytes_.size());
        jpeg_read_header(&decoder_, TRUE);
        return true;
    }

    bool readRows(ByteImage& pixels) {
        if (setjmp(errors_.wayOut)) return false;
        decoder_.out_color_space = JCS_EXT_RGBA;
        jpeg_start_decompress(&decoder_);
        while (decoder_.output_scanline < decoder_.output_height) {
            auto* row = reinterpret_cast<JSAMPROW>(&pixels.at(0, static_cast<int>(decoder_.output_scanline)));
            jpeg_read_scanlines(&decoder_, &row, 1);
        }
        jpeg_finish_decompress(&decoder_);
        return true;
    }

    [[noreturn]] static void giveUp(j_common_ptr decoder) {
        auto& errors = *reinterpret_cast<Errors*>(decoder->err);
        errors.manager.format_message(decoder, errors.message.data());
        std::longjmp(errors.wayOut, 1);
    }

    /// libjpeg only warns of damage and of a missing end. Stray bytes between segments do no harm, and
    /// cameras write them.
    static void onMessage(j_common_ptr decoder, int level) {
        if (level < 0 && decoder->err->msg_code != JWRN_EXTRANEOUS_DATA) giveUp(decoder);
    }

    static void onProgress(j_common_ptr decoder) {
        if (reinterpret_cast<j_decompress_ptr>(decoder)->input_scan_number <= kMostScans) return;
        auto& errors = *reinterpret_cast<Errors*>(decoder->err);
        std::snprintf(errors.message.data(), errors.message.size(), "more than %d scans", kMostScans);
        std::longjmp(errors.wayOut, 1);
    }

    std::span<const std::byte> bytes_;
    const std::string& where_;
    Errors errors_{};
    jpeg_progress_mgr progress_{};
    jpeg_decompress_struct decoder_{};
};

}

DecodedImage decodeJpeg(std::span<const std::byte> bytes, const std::string& where) {
    return JpegReader(bytes, where).readPicture();
}

}
