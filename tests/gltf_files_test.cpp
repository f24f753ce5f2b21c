// labels: robustness
// What a scene file may reach for, and what happens when it reaches further.
#include <filesystem>

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "tests/gltf_builder.h"
#include "tests/temporary_folder.h"

namespace eyeray {
namespace {

using test::GltfBuilder;

/// A folder with a scene beside a secret, a folder, a pipe and a way out.
struct Trap {
    TemporaryFolder outer;
    std::filesystem::path inner = outer.path() / "scene";

    Trap() {
        std::filesystem::create_directories(inner / "folder");
        writeFileAtomically(outer.path() / "secret.bin", std::vector<std::byte>(36));
        std::filesystem::create_symlink(outer.path() / "secret.bin", inner / "link.bin");
        std::filesystem::create_symlink(outer.path(), inner / "way out");
        std::filesystem::create_symlink("loop", inner / "loop");
        EXPECT_EQ(::mkfifo((inner / "pipe").c_str(), 0600), 0);
    }

    void write(const std::string& text) const {
        writeFileAtomically(inner / "scene.gltf", std::as_bytes(std::span(text)));
    }
};

const std::vector<std::string> kLeadingOut{"../secret.bin",
                                           "%2e%2e/secret.bin",
                                           "folder/../../secret.bin",
                                           "/etc/passwd",
                                           "%2Fetc%2Fpasswd",
                                           "file:///etc/passwd",
                                           "http://localhost/x.bin",
                                           "C:\\secret.bin",
                                           "folder\\secret.bin",
                                           "a%00.bin",
                                           "%zz",
                                           "%2",
                                           "..",
                                           "link.bin",
                                           "way%20out/secret.bin"};

TEST(GltfFiles, BuffersAreReadFromTheScenesOwnFolderOnly) {
    const Trap trap;
    GltfBuilder b;
    b.triangle();
    std::vector<std::string> uris = kLeadingOut;
    for (const char* const uri : {"folder", ".", "pipe", "loop", "missing.bin", "scene.gltf/x"})
        uris.emplace_back(uri);
    uris.push_back(std::string(5000, 'x'));
    for (const std::string& uri : uris) {
        trap.write(b.gltf(uri));
        ImportReport report;
        EXPECT_THROW(importGltf(trap.inner / "scene.gltf", report), InputError) << uri;
    }
    trap.write(b.gltf("./folder/buffer.bin"));
    writeFileAtomically(trap.inner / "folder/buffer.bin", b.buffer);
    ImportReport report;
    EXPECT_EQ(importGltf(trap.inner / "scene.gltf", report).objects.size(), 1U);
}

TEST(GltfFiles, ImagesAreReadFromTheScenesOwnFolderOnly) {
    const Trap trap;
    writeFileAtomically(trap.outer.path() / "secret.bin",
                        encodeDisplayed(ByteImage(1, 1), ImageFormat::Png, {}));
    for (const std::string& uri : kLeadingOut) {
        GltfBuilder b;
        b.push("images", {{"uri", uri}});
        b.push("textures", {{"source", 0}});
        b.push("materials", {{"emissiveTexture", {{"index", 0}}}});
        b.triangle();
        trap.write(b.gltf());
        test::Imported imported;
        try { // links are found out when the image is read, the rest at once
            imported.scene = importGltf(trap.inner / "scene.gltf", imported.report);
            EXPECT_TRUE(imported.scene.images.empty()) << uri;
            EXPECT_EQ(imported.repaired("images[0]"), 1) << uri;
        } catch (const InputError& error) {
            EXPECT_NE(error.where().find("images[0]"), std::string::npos) << uri;
        }
    }
}

TEST(GltfFiles, PathsThatAreNoFilesAreRefused) {
    const Trap trap;
    ImportReport report;
    for (const std::filesystem::path& path :
         {trap.inner, trap.inner / "pipe", trap.inner / "missing", trap.inner / "loop",
          std::filesystem::path("/dev/zero"), std::filesystem::path()})
        EXPECT_THROW(importGltf(path, report), InputError) << path;
}

}
}
