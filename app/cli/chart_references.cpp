#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "app/cli/chart.h"
#include "app/document/user_folders.h"
#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"
#include "core/image/read_picture.h"
#include "core/image/sha256.h"
#include "core/scene/gltf.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{1} << 30U;

/// Of all that the scene holds, textures and edits too: of the file that it would be saved as.
std::string contentHash(const Scene& scene, const fs::path& folder) {
    const fs::path file = folder / fmt::format("scene-{}.glb", getpid());
    exportGltf(scene, file);
    std::string hash = sha256HexOfFile(file);
    fs::remove(file);
    return hash;
}

class KeptReferences {
public:
    KeptReferences(const OpenedScene& opened, const ExperimentPlan& plan)
        : document_(opened.document), plan_(plan), folder_(cacheFolder() / "eyeray" / "references") {
        fs::create_directories(folder_);
        common_ = fmt::format("{}\n{}\n{}x{} {} samples, seed {}\n", contentHash(*plan.scene, folder_),
                              sha256HexOfFile("/proc/self/exe"), plan.width, plan.height,
                              plan.referenceSamples, plan.seed);
    }

    std::optional<ReferenceHalves> find(const TraceSettings& model) const {
        const fs::path file = fileOf(model);
        std::error_code error;
        if (!fs::is_regular_file(file, error)) return std::nullopt;
        const ColorImage both = readPicture(readFile(file, kMostBytes), file.string()).linear;
        if (both.width() != plan_.width || both.height() != 2 * plan_.height) return std::nullopt;
        ReferenceHalves halves{ColorImage(plan_.width, plan_.height), ColorImage(plan_.width, plan_.height)};
        const auto middle = both.values().begin() + static_cast<std::ptrdiff_t>(both.values().size() / 2);
        std::copy(both.values().begin(), middle, halves[0].values().begin());
        std::copy(middle, both.values().end(), halves[1].values().begin());
        return halves;
    }

    /// As one picture, the second half below the first.
    void keep(const TraceSettings& model, const ReferenceHalves& halves) const {
        ColorImage both(plan_.width, 2 * plan_.height);
        const auto middle = std::ranges::copy(halves[0].values(), both.values().begin()).out;
        std::ranges::copy(halves[1].values(), middle);
        writeFileAtomically(fileOf(model), encodeRadiance(both, ImageFormat::Exr, {}));
    }

private:
    fs::path fileOf(const TraceSettings& model) const {
        const Document plain = makeDocument(plan_.scene);
        Document asked = plain;
        asked.camera = document_.camera;
        asked.render.trace = model;
        std::string text = common_;
        for (const Command& command : commandsBetween(plain, asked)) text += command.text() + "\n";
        return folder_ / (sha256Hex(std::as_bytes(std::span(text))) + ".exr");
    }

    const Document document_;
    const ExperimentPlan& plan_;
    const fs::path folder_;
    std::string common_; // of all keys
};

}

ReferenceStore referenceStore(const OpenedScene& opened, const ExperimentPlan& plan) {
    ReferenceStore none{[](const TraceSettings&) { return std::nullopt; },
                        [](const TraceSettings&, const ReferenceHalves&) {}};
    if (cacheFolder().empty()) return none;
    try {
        const auto kept = std::make_shared<const KeptReferences>(opened, plan);
        return {[kept](const TraceSettings& model) -> std::optional<ReferenceHalves> {
                    try {
                        return kept->find(model);
                    } catch (const Error&) {
                        return std::nullopt; // damaged: made anew
                    }
                },
                [kept](const TraceSettings& model, const ReferenceHalves& halves) {
                    try {
                        kept->keep(model, halves);
                    } catch (const Error&) { // NOLINT(bugprone-empty-catch): a full disk costs time, no more
                    }
                }};
    } catch (const std::exception&) {
        return none;
    }
}

}
