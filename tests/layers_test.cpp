// labels: unit
// The house rule that includes point only down the layers, and that third-party code is met in few places.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

struct Room {
    std::string_view path;
    int layer;
};

// Rooms of one layer may not include each other.
constexpr std::array kRooms = {
    Room{"core/base/", 0},      Room{"core/image/", 1},  Room{"core/geometry/", 1}, Room{"core/scene/", 2},
    Room{"core/transport/", 3}, Room{"core/render/", 4}, Room{"core/study/", 5},    Room{"app/", 6}};

struct Owner {
    std::string_view header; // beginning of what stands between the angle brackets
    std::string_view room;   // the only place that may include it
};

constexpr std::array kOwners = {Owner{"tiny_gltf.h", "core/scene/"},
                                Owner{"png.h", "core/image/"},
                                Owner{"jpeglib.h", "core/image/"},
                                Owner{"OpenEXR/", "core/image/"},
                                Owner{"Imf", "core/image/"},
                                Owner{"Imath", "core/image/"},
                                Owner{"openssl/", "core/image/"},
                                Owner{"GLFW/", "app/"},
                                Owner{"imgui", "app/"},
                                Owner{"GL/", "app/"},
                                Owner{"CLI/", "app/"}};

const Room* roomOf(std::string_view path) {
    const auto* const room =
        std::find_if(kRooms.begin(), kRooms.end(), [&](const Room& r) { return path.starts_with(r.path); });
    return room == kRooms.end() ? nullptr : room;
}

/// What a line includes, with its opening quote or bracket: `"core/base/math.h` or `<vector`. Empty for other
/// lines.
std::string_view included(std::string_view line) {
    const auto skipBlanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size())); };
    skipBlanks();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skipBlanks();
    if (!line.starts_with("include")) return {};
    line.remove_prefix(7);
    skipBlanks();
    return line.substr(0, line.find_first_of("\">", 1));
}

/// What is wrong with this line of this file (a path from the project's root), or nothing.
std::optional<std::string> complaint(std::string_view file, std::string_view line) {
    const std::string_view include = included(line);
    if (include.empty()) return std::nullopt;
    const std::string_view header = include.substr(1);
    if (const auto* const owner = std::find_if(kOwners.begin(), kOwners.end(),
                                               [&](const Owner& o) { return header.starts_with(o.header); });
        owner != kOwners.end() && !file.starts_with(owner->room))
        return "only " + std::string(owner->room) + " may include it";
    if (include.front() != '"') return std::nullopt;

    const Room* const from = roomOf(file);
    const Room* const to = roomOf(header);
    if (from == nullptr) return "the file is in no room that the layers name";
    if (to == nullptr) return "quotes are for paths that begin with a room of ours";
    if (to->layer > from->layer) return "it climbs up from " + std::string(from->path);
    if (to->layer == from->layer && to != from) return "it goes sideways from " + std::string(from->path);
    return std::nullopt;
}

/// Calls visit(path from the root, line) for each line of the C++ files in core/ and app/; returns how many
/// files.
template <class Visit>
int forEachLine(const Visit& visit) {
    const fs::path root = EYERAY_SOURCE_DIR;
    int files = 0;
    for (const char* const top : {"core", "app"})
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
            const fs::path extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp") continue;
            ++files;
            std::ifstream in(entry.path());
            for (std::string line; std::getline(in, line);)
                visit(fs::relative(entry.path(), root).string(), line);
        }
    return files;
}

}

TEST(Layers, NoIncludeOfOursClimbsOrGoesSideways) {
    const int files = forEachLine([](const std::string& file, const std::string& line) {
        const std::optional<std::string> wrong = complaint(file, line);
        EXPECT_FALSE(wrong) << file << ": " << line << ": " << wrong.value_or("");
    });
    EXPECT_GT(files, 0);
}

TEST(Layers, TheCommandLineParserIsIncludedInOneFileOnly) {
    std::vector<std::string> files;
    forEachLine([&](const std::string& file, const std::string& line) {
        if (included(line).starts_with("<CLI/")) files.push_back(file);
    });
    EXPECT_LE(files.size(), 1U) << testing::PrintToString(files);
}

TEST(Layers, AnIncludeOfALowerLayerOrOfTheSameRoomIsFine) {
    EXPECT_FALSE(complaint("core/scene/scene.h", "#include \"core/geometry/mesh.h\""));
    EXPECT_FALSE(complaint("core/scene/scene.h", "#include \"core/scene/camera.h\""));
    EXPECT_FALSE(complaint("app/main.cpp", "#include \"core/render/film.h\""));
    EXPECT_FALSE(complaint("core/base/math.h", "#include <vector>"));
    EXPECT_FALSE(complaint("core/base/math.h", "// core/base may not #include \"app/main.h\""));
}

TEST(Layers, AClimbingIncludeIsCaught) {
    EXPECT_TRUE(complaint("core/base/math.h", "#include \"core/image/pixels.h\""));
    EXPECT_TRUE(complaint("core/study/ledger.h", "#include \"app/document.h\""));
    EXPECT_TRUE(complaint("core/scene/world.cpp", "  #  include \"core/transport/light.h\""));
}

TEST(Layers, AnIncludeOfASiblingRoomIsCaught) {
    EXPECT_TRUE(complaint("core/image/png.cpp", "#include \"core/geometry/ray.h\""));
    EXPECT_TRUE(complaint("core/geometry/mesh.h", "#include \"core/image/pixels.h\""));
}

TEST(Layers, AnIncludeOutsideTheRoomsIsCaught) {
    EXPECT_TRUE(complaint("core/base/math.cpp", "#include \"math.h\""));
    EXPECT_TRUE(complaint("core/attic/math.cpp", "#include \"core/base/math.h\""));
}

TEST(Layers, AThirdPartyHeaderOutsideItsRoomIsCaught) {
    EXPECT_TRUE(complaint("core/render/film.cpp", "#include <GLFW/glfw3.h>"));
    EXPECT_TRUE(complaint("core/study/chart.cpp", "#include \"imgui.h\""));
    EXPECT_TRUE(complaint("core/geometry/bvh.cpp", "#include <tiny_gltf.h>"));
    EXPECT_TRUE(complaint("app/gl/screenshot.cpp", "#include <png.h>"));
    EXPECT_FALSE(complaint("core/scene/import.cpp", "#include <tiny_gltf.h>"));
    EXPECT_FALSE(complaint("app/gl/loader.h", "#include <GL/glcorearb.h>"));
}
