#include <algorithm>

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

/// Names a channel in the header and shows OpenEXR where its floats lie.
void addChannel(Imf::Header& header, Imf::FrameBuffer& frame, const ImageChannel& channel) {
    const ColorImage& image = *channel.image;
    // OpenEXR takes one kind of slice for reading and writing; written ones it leaves as they are.
    auto* const first = const_cast<float*>(&image.values().front()[channel.component]);
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(first), sizeof(Color),
                                          sizeof(Color) * static_cast<std::size_t>(image.width())));
}

}

// Scan lines under ZIP compression. A key that OpenEXR itself uses, such as "channels", is no key for
// metadata.
std::vector<std::byte> encodeChannels(std::span<const ImageChannel> channels, const Metadata& metadata) {
    const ColorImage& image = *channels.front().image;
    Imf::Header header(image.width(), image.height());
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, text] : metadata) header.insert(key, Imf::StringAttribute(text));
    Imf::FrameBuffer frame;
    for (const ImageChannel& channel : channels) {
        ENSURE(channel.image->width() == image.width() && channel.image->height() == image.height());
        addChannel(header, frame, channel);
    }

    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height());
    } // its end writes the table of blocks
    return stream.take();
}

}
