#pragma once
// PNG and JPEG files of the kinds that Eyeray reads and does not write.

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <cstdio> // jpeglib.h needs it
#include <jpeglib.h>
#include <png.h>

namespace eyeray {

struct PngKind {
    int width, height, bits, colorType;
    bool interlaced = false;
};

/// `rows` are bytes as they stand in the file, before filtering; `more` adds chunks before the header is
/// written.
inline std::vector<std::byte> makePng(const PngKind& kind,
                                      const std::vector<std::vector<unsigned char>>& rows,
                                      const std::function<void(png_structp, png_infop)>& more = {}) {
    std::vector<std::byte> bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    const auto append = [](png_structp writer, png_bytep data, std::size_t size) {
        auto& file = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(writer));
        const auto added = std::as_bytes(std::span(data, size));
        file.insert(file.end(), added.begin(), added.end());
    };
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(kind.width), static_cast<png_uint_32>(kind.height),
                 kind.bits, kind.colorType, kind.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    if (more) more(png, info);
    png_write_info(png, info);
    const int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; ++pass)
        for (const auto& row : rows) png_write_row(png, row.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

/// `samples` hold `components` bytes a pixel, row by row. Best quality, no chroma subsampling;
/// `more` changes the encoder's settings.
inline std::vector<std::byte> makeJpeg(int width, int height, int components, J_COLOR_SPACE colors,
                                       std::vector<unsigned char> samples,
                                       const std::function<void(j_compress_ptr)>& more = {}) {
    jpeg_compress_struct encoder{};
    jpeg_error_mgr errors{};
    encoder.err = jpeg_std_error(&errors);
    jpeg_create_compress(&encoder);
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&encoder, &buffer, &size);
    encoder.image_width = static_cast<JDIMENSION>(width);
    encoder.image_height = static_cast<JDIMENSION>(height);
    encoder.input_components = components;
    encoder.in_color_space = colors;
    jpeg_set_defaults(&encoder);
    jpeg_set_quality(&encoder, 100, TRUE);
    encoder.comp_info[0].h_samp_factor = encoder.comp_info[0].v_samp_factor = 1;
    if (more) more(&encoder);
    jpeg_start_compress(&encoder, TRUE);
    while (encoder.next_scanline < encoder.image_height) {
        JSAMPROW row = &samples[std::size_t{encoder.next_scanline} * encoder.image_width *
                                static_cast<unsigned>(components)];
        jpeg_write_scanlines(&encoder, &row, 1);
    }
    jpeg_finish_compress(&encoder);
    const auto written = std::as_bytes(std::span(buffer, size));
    std::vector<std::byte> bytes(written.begin(), written.end());
    jpeg_destroy_compress(&encoder);
    std::free(buffer);
    return bytes;
}

}
