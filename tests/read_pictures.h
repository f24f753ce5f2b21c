#pragma once
// Readers of the formats that Eyeray writes, by ways of their own: what tests check the encoders with.

#include <cmath>
#include <cstddef>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include "core/image/encode.h"
#include "core/image/pixels.h"

namespace eyeray {

/// Takes a file's bytes from its front on.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    std::span<const std::byte> take(std::size_t count) {
        if (count > rest_.size()) throw std::runtime_error("the file is too short");
        const auto taken = rest_.first(count);
        rest_ = rest_.subspan(count);
        return taken;
    }
    int byte() { return std::to_integer<int>(take(1)[0]); }
    std::string line() {
        std::string text;
        for (char c = static_cast<char>(byte()); c != '\n'; c = static_cast<char>(byte())) text += c;
        return text;
    }
    bool atEnd() const { return rest_.empty(); }

private:
    std::span<const std::byte> rest_;
};

struct StatedSize {
    int width, height;
};

inline StatedSize sizeIn(const std::string& line, const char* pattern) {
    StatedSize size{};
    if (std::sscanf(line.c_str(), pattern, &size.width, &size.height) != 2)
        throw std::runtime_error("no size");
    return size;
}

inline ColorImage readPfm(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    if (reader.line() != "PF") throw std::runtime_error("no PFM");
    const auto [width, height] = sizeIn(reader.line(), "%d %d");
    if (reader.line() != "-1.0") throw std::runtime_error("not little-endian");
    ColorImage image(width, height);
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            std::memcpy(&image.at(x, y), reader.take(sizeof(Color)).data(), sizeof(Color));
    if (!reader.atEnd()) throw std::runtime_error("bytes after the picture");
    return image;
}

inline ByteImage readPpm(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    if (reader.line() != "P6") throw std::runtime_error("no PPM");
    const auto [width, height] = sizeIn(reader.line(), "%d %d");
    if (reader.line() != "255") throw std::runtime_error("not 8 bits");
    ByteImage image(width, height);
    for (Rgba8& pixel : image.values())
        for (std::uint8_t* const channel : {&pixel.r, &pixel.g, &pixel.b})
            *channel = static_cast<std::uint8_t>(reader.byte());
    if (!reader.atEnd()) throw std::runtime_error("bytes after the picture");
    return image;
}

inline std::vector<int> readHdrRow(ByteReader& reader, int width) {
    std::vector<int> component;
    while (component.size() < static_cast<std::size_t>(width)) {
        const int count = reader.byte();
        if (count > 128)
            component.insert(component.end(), static_cast<std::size_t>(count - 128), reader.byte());
        else
            for (int i = 0; i < count; ++i) component.push_back(reader.byte());
    }
    if (component.size() != static_cast<std::size_t>(width))
        throw std::runtime_error("a run passes the row's end");
    return component;
}

inline ColorImage readHdr(std::span<const std::byte> bytes) {
    ByteReader reader(bytes);
    if (reader.line() != "#?RADIANCE") throw std::runtime_error("no HDR");
    while (!reader.line().empty()) {
    }
    const std::string resolution = reader.line();
    StatedSize size{};
    if (std::sscanf(resolution.c_str(), "-Y %d +X %d", &size.height, &size.width) != 2)
        throw std::runtime_error("no size");
    const bool withRuns = size.width >= 8 && size.width <= 32767;
    ColorImage image(size.width, size.height);
    for (int y = 0; y < size.height; ++y) {
        std::vector<std::vector<int>> rgbe(4);
        if (withRuns) {
            if (reader.byte() != 2 || reader.byte() != 2) throw std::runtime_error("no run-length row");
            const int high = reader.byte();
            if (high * 256 + reader.byte() != size.width) throw std::runtime_error("another width");
            for (auto& component : rgbe) component = readHdrRow(reader, size.width);
        } else {
            for (int i = 0; i < 4 * size.width; ++i)
                rgbe[static_cast<std::size_t>(i % 4)].push_back(reader.byte());
        }
        for (int x = 0; x < size.width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            const auto channel = [&](std::size_t c) {
                return std::ldexp(static_cast<float>(rgbe[c][i]), rgbe[3][i] - 136);
            };
            image.at(x, y) = Color(channel(0), channel(1), channel(2));
        }
    }
    if (!reader.atEnd()) throw std::runtime_error("bytes after the picture");
    return image;
}

/// OpenEXR's own reader over bytes in memory.
class ExrBytes : public Imf::IStream {
public:
    explicit ExrBytes(std::span<const std::byte> bytes) : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char* into, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ + size > bytes_.size()) throw std::runtime_error("the file is too short");
        std::memcpy(into, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<const std::byte> bytes_;
    std::size_t position_ = 0;
};

struct ExrPicture {
    ColorImage image;
    Metadata strings; // all string attributes
};

inline ExrPicture readExr(std::span<const std::byte> bytes) {
    ExrBytes stream(bytes);
    Imf::InputFile file(stream, 0);
    const Imath::Box2i window = file.header().dataWindow();
    ExrPicture picture{{window.max.x + 1, window.max.y + 1}, {}};
    Imf::FrameBuffer frame;
    const char* const names[] = {"R", "G", "B"};
    for (int i = 0; i < 3; ++i) {
        const Imf::Channel* const channel = file.header().channels().findChannel(names[i]);
        if (!channel || channel->type != Imf::FLOAT) throw std::runtime_error("no channel of floats");
        frame.insert(names[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&picture.image.at(0, 0)[i]),
                                          sizeof(Color),
                                          sizeof(Color) * static_cast<std::size_t>(picture.image.width())));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    for (auto attribute = file.header().begin(); attribute != file.header().end(); ++attribute)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
            picture.strings.emplace_back(attribute.name(), text->value());
    return picture;
}

}
