#include <algorithm>
#include <array>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include "core/image/codecs.h"

namespace eyeray {
namespace {

/// OpenEXR's way to a file, into memory. It goes back once, to fill in where each block lies.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("memory") {}

    void write(const char* data, int count) override {
        const auto added = std::as_bytes(std::span(data, static_cast<std::size_t>(count)));
        bytes_.resize(std::max(bytes_.size(), position_ + added.size()));
        std::copy(added.begin(), added.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(position_));
        position_ += added.size();
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    std::size_t position_ = 0;
};

/// Names the image's channels in the header and shows OpenEXR where their floats lie.
void addChannels(Imf::Header& header, Imf::FrameBuffer& frame, const ColorImage& image) {
    const auto rowBytes = sizeof(Color) * static_cast<std::size_t>(image.width());
    for (int i = 0; i < 3; ++i) {
        const char* const name = std::array{"R", "G", "B"}[static_cast<std::size_t>(i)];
        // OpenEXR takes one kind of slice for reading and writing; written ones it leaves as they are.
        auto* const first = const_cast<float*>(&image.values().front()[i]);
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first), sizeof(Color), rowBytes));
    }
}

}

std::vector<std::byte> encodeExr(const ColorImage& image, const Metadata& metadata) {
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, text] : metadata) header.insert(key, Imf::StringAttribute(text));
    Imf::FrameBuffer frame;
    addChannels(header, frame, image);

    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height());
    } // its end writes the table of blocks
    return stream.take();
}

}
