#include "app/document/scene_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/document/picture_file.h"
#include "core/base/errors.h"
#include "core/image/sha256.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

std::string lookAtLine(const fs::path& path) {
    std::ifstream file(path);
    const auto json = nlohmann::json::parse(file, nullptr, false);
    const auto pointer = nlohmann::json::json_pointer("/scenes/0/extras/eyeray/lookAt");
    return json.is_object() && json.contains(pointer) && json[pointer].is_string()
               ? json[pointer].get<std::string>()
               : "";
}

fs::path builtinPath(const std::string& name) {
    if (name.empty() || name.find_first_of("/\\.") != std::string::npos) return {};
    const fs::path path = assetsFolder() / "scenes" / (name + ".gltf");
    std::error_code error;
    return fs::is_regular_file(path, error) ? path : fs::path();
}

OpenedScene openFile(const fs::path& path, const std::string& reference, const std::stop_token& stop) {
    const auto start = std::chrono::steady_clock::now();
    OpenedScene opened;
    opened.path = path;
    opened.reference = reference;
    auto scene = std::make_shared<const Scene>(importGltf(path, opened.report, stop));
    if (stop.stop_requested()) return opened;
    opened.document = makeDocument(std::move(scene));
    opened.meterExposure = !opened.document.scene->statesExposure;
    opened.sha256 = sha256HexOfFile(path);
    opened.loadSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return opened;
}

OpenedScene openLab(const LabDemo& demo) {
    OpenedScene opened;
    opened.reference = demo.name;
    opened.document = labDocument(demo, demo.slider.start);
    opened.sha256 = sha256Hex(std::as_bytes(std::span(demo.name)));
    return opened;
}

OpenedScene openPicture(const fs::path& picture, const std::stop_token& stop) {
    const PictureState state = readPictureState(picture);
    const fs::path builtin = builtinPath(state.scene), file = picture.parent_path() / state.scene;
    std::error_code error;
    const LabDemo* const demo = labDemoNamed(state.scene);
    if (demo == nullptr && builtin.empty() && !fs::exists(file, error))
        throw InputError(picture.string(), fmt::format("its scene {} is missing", state.scene),
                         "put the scene file back where it was, as seen from the picture");
    OpenedScene opened = demo != nullptr   ? openLab(*demo)
                         : builtin.empty() ? openFile(file, file.string(), stop)
                                           : openFile(builtin, state.scene, stop);
    if (stop.stop_requested()) return opened;
    if (opened.sha256 != state.sha256)
        opened.report.lines.push_back(
            {ImportReport::Kind::Repaired,
             fmt::format("{} has changed since the picture was made: it may look different", state.scene)});
    for (const std::string& line : state.commands)
        opened.document = apply(opened.document, Command::parse(line));
    opened.meterExposure = false;
    return opened;
}

}

fs::path assetsFolder() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path installed = program.parent_path() / EYERAY_INSTALLED_ASSETS;
    return fs::is_directory(installed, error) ? fs::weakly_canonical(installed, error)
                                              : fs::path(EYERAY_BUILD_ASSETS);
}

std::vector<BuiltinScene> builtinScenes() {
    std::vector<BuiltinScene> scenes;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(assetsFolder() / "scenes", error))
        if (entry.path().extension() == ".gltf")
            scenes.push_back({entry.path().stem().string(), lookAtLine(entry.path()), entry.path()});
    std::sort(scenes.begin(), scenes.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return scenes;
}

OpenedScene openScene(const std::string& nameOrPath, const std::stop_token& stop) {
    if (const LabDemo* const demo = labDemoNamed(nameOrPath)) return openLab(*demo);
    if (const fs::path builtin = builtinPath(nameOrPath); !builtin.empty())
        return openFile(builtin, nameOrPath, stop);
    const fs::path path = nameOrPath;
    std::error_code error;
    if (!fs::exists(path, error))
        throw InputError(nameOrPath, "there is no such scene or file",
                         "see `eyeray scenes` for the built-in ones");
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return std::tolower(c); });
    if (extension == ".png") return openPicture(path, stop);
    return openFile(path, nameOrPath, stop);
}

std::string lastingReference(const OpenedScene& opened) {
    if (opened.path == builtinPath(opened.reference)) return opened.reference;
    std::error_code error;
    return fs::absolute(opened.path, error).lexically_normal().string();
}

void applyTo(OpenedScene& opened, const std::vector<Command>& commands) {
    for (const Command& command : commands) {
        opened.document = apply(opened.document, command);
        if (command.name() == "set" && command.find("exposure")) opened.meterExposure = false;
    }
}

}
