#include "core/image/sha256.h"

#include <array>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "core/base/errors.h"
#include "core/image/file_descriptor.h"

namespace eyeray {
namespace {

class Sha256 {
public:
    Sha256() { check(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1); }

    void add(std::span<const std::byte> bytes) {
        check(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1);
    }

    std::string hex() {
        std::array<unsigned char, 32> digest{};
        check(EVP_DigestFinal_ex(context_.get(), digest.data(), nullptr) == 1);
        std::string result;
        for (const unsigned char byte : digest) result += fmt::format("{:02x}", byte);
        return result;
    }

private:
    static void check(bool done) {
        if (!done) throw Failure{"SHA-256", "OpenSSL cannot compute it", "check the OpenSSL installation"};
    }

    struct Free {
        void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
    };
    std::unique_ptr<EVP_MD_CTX, Free> context_{EVP_MD_CTX_new()};
};

}

std::string sha256Hex(std::span<const std::byte> bytes) {
    Sha256 sum;
    sum.add(bytes);
    return sum.hex();
}

std::string sha256HexOfFile(const std::filesystem::path& path) {
    const FileDescriptor file = openForReading(path);
    std::vector<std::byte> piece(1U << 20U);
    Sha256 sum;
    while (const std::size_t size = readInto(file, piece, path)) sum.add(std::span(piece).first(size));
    return sum.hex();
}

}
