#include <array>
#include <cstring>
#include <exception>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <fmt/format.h>

#include "core/base/errors.h"
#include "core/image/codecs.h"

namespace eyeray {
namespace {

/// OpenEXR's way to a file, over bytes in memory.
class MemoryStream : public Imf::IStream {
public:
    explicit MemoryStream(std::span<const std::byte> bytes) : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char* into, int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (count < 0 || position_ > bytes_.size() || size > bytes_.size() - position_)
            throw std::runtime_error("ends too early");
        std::memcpy(into, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

private:
    std::span<const std::byte> bytes_;
    std::uint64_t position_ = 0;
};

}

ColorImage decodeExr(std::span<const std::byte> bytes, const std::string& where) {
    constexpr std::array<const char*, 3> kNames = {"R", "G", "B"};
    try {
        MemoryStream stream(bytes);
        Imf::InputFile file(stream, 0);
        const Imath::Box2i window = file.header().dataWindow();
        const long long width = 1LL + window.max.x - window.min.x, height = 1LL + window.max.y - window.min.y;
        checkPictureSize(width, height, where);
        ColorImage image(static_cast<int>(width), static_cast<int>(height));
        Imf::FrameBuffer frame;
        for (int c = 0; c < 3; ++c) {
            const char* const name = kNames[static_cast<std::size_t>(c)];
            if (file.header().channels().findChannel(name) == nullptr)
                throw InputError{where, fmt::format("has no channel {}", name),
                                 "give a picture in R, G and B"};
            frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &image.values().front()[c], window, sizeof(Color),
                                                sizeof(Color) * static_cast<std::size_t>(width)));
        }
        file.setFrameBuffer(frame);
        file.readPixels(window.min.y, window.max.y);
        return image;
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) { // OpenEXR throws kinds of its own
        const std::string what = error.what();
        throw InputError{where, "cannot be read: " + what.substr(0, what.find('\n')), "write it again"};
    }
}

}
