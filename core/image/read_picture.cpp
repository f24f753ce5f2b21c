#include "core/image/read_picture.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/image/byte_cursor.h"
#include "core/image/codecs.h"
#include "core/image/decode.h"
#include "core/image/srgb.h"

namespace eyeray {
namespace {

bool startsWith(std::span<const std::byte> bytes, std::string_view start) {
    return bytes.size() >= start.size() && std::memcmp(bytes.data(), start.data(), start.size()) == 0;
}

int numberIn(const std::string& text, const ByteCursor& file) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1)
        file.refuse("says no size that can be read");
    return number;
}

struct Size {
    int width, height;
};
Size sizeFrom(ByteCursor& file) {
    const int width = numberIn(file.until(" \n\t"), file), height = numberIn(file.until(" \n\t"), file);
    checkPictureSize(width, height, file.where());
    return {width, height};
}

ByteImage readPpm(ByteCursor file) {
    file.until("\n");
    const auto [width, height] = sizeFrom(file);
    if (file.until(" \n\t") != "255") file.refuse("has not 8 bits a channel");
    const auto bytes = file.take(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    ByteImage image(width, height);
    for (std::size_t i = 0; i < image.values().size(); ++i) {
        const auto channel = [&](std::size_t c) { return std::to_integer<std::uint8_t>(bytes[3 * i + c]); };
        image.values()[i] = {channel(0), channel(1), channel(2)};
    }
    return image;
}

/// Rows from the bottom up; a negative scale says that the floats are little-endian.
ColorImage readPfm(ByteCursor file) {
    file.until("\n");
    const auto [width, height] = sizeFrom(file);
    const bool little = file.until("\n").starts_with('-');
    const auto bytes =
        file.take(sizeof(Color) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    ColorImage image(width, height);
    std::size_t at = 0;
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c, at += 4) {
                std::uint32_t bits = 0;
                for (std::size_t k = 0; k < 4; ++k)
                    bits |= std::to_integer<std::uint32_t>(bytes[at + (little ? k : 3 - k)]) << (8 * k);
                image.at(x, y)[c] = std::bit_cast<float>(bits);
            }
    return image;
}

/// One component of a row: runs of one byte and stretches of single ones.
void readRuns(ByteCursor& file, std::span<std::uint8_t> row) {
    for (std::size_t x = 0; x < row.size();) {
        const unsigned code = file.byte();
        const std::size_t count = code > 128 ? code - 128 : code;
        if (count == 0 || count > row.size() - x) file.refuse("has a run that passes the end of its row");
        if (code > 128) {
            std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count,
                        static_cast<std::uint8_t>(file.byte()));
        } else {
            for (std::size_t i = 0; i < count; ++i) row[x + i] = static_cast<std::uint8_t>(file.byte());
        }
        x += count;
    }
}

/// G. Ward 1991, "Real Pixels", Graphics Gems II; run lengths in each component where the width allows them.
ColorImage readHdr(ByteCursor file) {
    while (!file.until("\n").empty()) {
    }
    const std::string rows = file.until(" "), heightText = file.until(" "), columns = file.until(" ");
    if (rows != "-Y" || columns != "+X") file.refuse("does not begin at the top left");
    const int height = numberIn(heightText, file), width = numberIn(file.until("\n"), file);
    checkPictureSize(width, height, file.where());
    ColorImage image(width, height);
    const auto columnsOf = static_cast<std::size_t>(width);
    std::vector<std::uint8_t> row(4 * columnsOf);
    for (int y = 0; y < height; ++y) {
        const auto start = file.take(4);
        const auto head = [&](std::size_t i) { return std::to_integer<unsigned>(start[i]); };
        const bool runs = width >= 8 && width < 32768 && head(0) == 2 && head(1) == 2 && head(2) < 128;
        if (runs) {
            if (head(2) * 256 + head(3) != static_cast<unsigned>(width)) file.refuse("changes its width");
            for (std::size_t c = 0; c < 4; ++c)
                readRuns(file, std::span(row).subspan(c * columnsOf, columnsOf));
        } else {
            const auto rest = file.take(4 * (columnsOf - 1));
            for (std::size_t i = 0; i < 4 * columnsOf; ++i)
                row[i % 4 * columnsOf + i / 4] =
                    std::to_integer<std::uint8_t>(i < 4 ? start[i] : rest[i - 4]);
        }
        for (std::size_t x = 0; x < columnsOf; ++x) {
            const int exponent = row[3 * columnsOf + x] - 136;
            for (std::size_t c = 0; c < 3; ++c)
                image.at(static_cast<int>(x), y)[static_cast<int>(c)] =
                    std::ldexp(static_cast<float>(row[c * columnsOf + x]), exponent);
        }
    }
    return image;
}

ColorImage linearOf(const ByteImage& displayed) {
    ColorImage linear(displayed.width(), displayed.height());
    for (std::size_t i = 0; i < linear.values().size(); ++i) {
        const Rgba8& p = displayed.values()[i];
        linear.values()[i] = {decodeSrgb8(p.r), decodeSrgb8(p.g), decodeSrgb8(p.b)};
    }
    return linear;
}

}

ReadPicture readPicture(std::span<const std::byte> bytes, const std::string& where) {
    if (startsWith(bytes, "\x76\x2f\x31\x01")) return {decodeExr(bytes, where), std::nullopt};
    if (startsWith(bytes, "PF\n")) return {readPfm({bytes, where}), std::nullopt};
    if (startsWith(bytes, "#?")) return {readHdr({bytes, where}), std::nullopt};
    ByteImage displayed =
        startsWith(bytes, "P6\n") ? readPpm({bytes, where}) : decodeImage(bytes, where).pixels;
    ColorImage linear = linearOf(displayed);
    return {std::move(linear), std::move(displayed)};
}

}
