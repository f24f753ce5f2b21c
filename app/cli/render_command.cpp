#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/figures.h"
#include "app/cli/interruption.h"
#include "app/cli/render_job.h"
#include "app/cli/run.h"
#include "core/base/errors.h"
#include "core/image/atomic_file.h"
#include "core/render/render_session.h"

namespace eyeray {
namespace {

constexpr int kDefaultWidth = 1280;
constexpr double kDefaultAspect = 16.0 / 9;
constexpr int kDefaultSamples = 16; // where no option says when to stop
constexpr auto kProgressInterval = std::chrono::milliseconds(100);

/// Renders until done or interrupted.
RenderStatus render(RenderSession& session, const RenderJob& job, bool progress) {
    session.start(job.world, job.document.camera, job.settings);
    RenderStatus status = session.wait(kProgressInterval);
    while (status.active() && !interrupted()) {
        if (progress) showProgress(status, job.settings.stop);
        status = session.wait(kProgressInterval);
    }
    if (progress) endProgress();
    session.stop();
    status = session.status();
    if (status.phase == RenderStatus::Phase::Failed) throw std::runtime_error(status.failure); // a whole line
    return status;
}

nlohmann::json statistics(const RenderJob& job, const RenderStatus& status) {
    nlohmann::json rays;
    for (int kind = 0; kind < kRayKinds; ++kind)
        rays[std::string(kRayKindNames[static_cast<std::size_t>(kind)])] =
            status.counts.rays[static_cast<std::size_t>(kind)];
    const World& world = *job.world;
    const Method method = job.settings.trace.method;
    return {{"scene", job.opened.reference},
            {"width", job.settings.width},
            {"height", job.settings.height},
            {"samples", status.samples},
            {"samples_per_pixel", status.samplesPerPixel},
            {"threads", status.threads},
            {"method", kMethodNames[static_cast<std::size_t>(method)]},
            {"seconds",
             {{"load", job.opened.loadSeconds},
              {"build", world.buildSeconds},
              {"first_image", status.secondsToFirstPass},
              {"render", status.seconds}}},
            {"rays", rays},
            {"mrays_per_second", status.mraysPerSecond()},
            {"deepest_ray", status.counts.deepest},
            {"accelerator", acceleratorFigures(world)},
            {"estimated_error", status.estimatedError},
            {"not_needed", isPhysical(method) ? world.needs.physical.reasons : world.needs.reasons},
            {"invalid_samples", status.counts.invalidSamples},
            {"peak_rss_bytes", peakRssBytes()}};
}

}

bool showsProgress(const RenderOptions& options) { return !options.quiet && isatty(STDERR_FILENO) != 0; }

void showProgress(const RenderStatus& status, const StopSettings& stop) {
    const double done = status.samples + status.passProgress;
    double left =
        stop.samples > 0 && done > 0 ? status.seconds / std::max(done, 1e-3) * (stop.samples - done) : 0;
    if (stop.seconds > 0) left = std::min(left, stop.seconds - status.seconds);
    fmt::print(stderr, "\r{:5.1f} of {} samples, {:.1f} s left, {:.2f} Mrays/s   ", done, stop.samples,
               std::max(0.0, left), status.mraysPerSecond());
    std::fflush(stderr);
}

void endProgress() { fmt::print(stderr, "\r\033[K"); }

PictureState stateOf(const RenderJob& job) {
    PictureState state{job.opened.reference, job.opened.sha256, {}};
    for (const Command& command : commandsBetween(originalOf(job.document), job.document))
        state.commands.push_back(command.text());
    return state;
}

void meterExposure(RenderJob& job, const ColorImage& picture) {
    if (job.opened.meterExposure)
        job.document.render.display.exposure = std::clamp(meteredExposure(picture), -20.0, 20.0);
}

void checkOutput(const std::filesystem::path& output) {
    formatOf(output);
    checkFolder(output);
}

void checkFolder(const std::filesystem::path& output) {
    const std::filesystem::path folder = output.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder))
        throw Failure(output.string(), "there is no such folder", "make it first");
}

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::is_directory(folder, error)) return;
    if (std::filesystem::exists(folder, error))
        throw InputError(folder.string(), "is no folder", "name one, or what is to be one");
    checkFolder(folder);
    std::filesystem::create_directory(folder, error);
    if (error) throw Failure(folder.string(), error.message(), "name a folder that can be written");
}

void setSize(RenderSettings& settings, const PictureOptions& options, double aspect) {
    const double ratio = aspect > 0 ? aspect : kDefaultAspect;
    const auto rounded = [](double side) {
        return std::clamp(static_cast<int>(std::lround(side)), 1, kMaxPictureSide);
    };
    settings.width =
        options.width.value_or(options.height ? rounded(*options.height * ratio) : kDefaultWidth);
    settings.height = options.height.value_or(rounded(settings.width / ratio));
}

OpenedScene openFor(const PictureOptions& options) {
    OpenedScene opened = openScene(options.scene);
    applyTo(opened, options.commands);
    return opened;
}

namespace {

RenderJob prepare(const RenderOptions& options) {
    RenderJob job;
    job.opened = openFor(options.picture);
    job.document = job.opened.document;
    if (options.layer && *options.layer != kAllLayers)
        job.document = apply(job.document, {"layer", {{"name", *options.layer}}});
    RenderSettings& settings = job.settings = job.document.render;
    setSize(settings, options.picture, job.document.aspect);
    settings.firstPass = options.picture.firstPass;
    settings.coarse = false;
    const auto given = [&](const char* key) {
        return std::any_of(options.picture.commands.begin(), options.picture.commands.end(),
                           [&](const Command& command) { return command.find(key).has_value(); });
    };
    const auto& ofScene = job.document.scene->settings;
    const auto stated = [&](const char* key) {
        return std::any_of(ofScene.begin(), ofScene.end(), [&](const std::string& line) {
            return Command::parse(line).find(key).has_value();
        });
    };
    if (!given("error") && (options.picture.stops || !stated("error"))) settings.stop.error = 0;
    if (!given("seconds")) settings.stop.seconds = 0;
    if (!options.picture.stops && !stated("samples")) settings.stop.samples = kDefaultSamples;
    if (options.picture.stops && !given("samples")) settings.stop.samples = 1 << 20;
    return job;
}

/// Renders the picture itself, and writes it or where its samples went; nothing is written if it is broken
/// off before its first sample is whole.
std::optional<RenderStatus> renderPicture(RenderJob& job, const RenderOptions& options,
                                          const std::vector<Layer>& layers) {
    RenderSession session(job.document.threads);
    RenderStatus status = render(session, job, showsProgress(options));
    const ColorImage counts = isSampleMap(layers) ? session.sampleCounts() : ColorImage{};
    const ColorImage image = session.takeImage();
    if (image.empty()) return std::nullopt;
    meterExposure(job, image);
    if (isSampleMap(layers)) {
        writeOneLayer(job, options, {layers.front(), status.samples, counts});
        return status;
    }
    writePicture(options.output, image, shownDisplay(job.document.render), stateOf(job));
    return status;
}

}

int run(const RenderOptions& options) {
    checkOutput(options.output);
    RenderJob job = prepare(options);
    const std::vector<Layer> layers = layersFor(job, options);
    heedInterrupts();
    job.world = buildWorld(job.document.scene, buildSettings(job.document));

    const bool byLayers = !layers.empty() && !isSampleMap(layers);
    const auto status = byLayers ? renderLayers(job, options, layers) : renderPicture(job, options, layers);
    if (!status) {
        fmt::print(stderr, "eyeray: interrupted before the first sample was whole: nothing is written\n");
        return 1;
    }
    if (options.stats) {
        const std::string text = statistics(job, *status).dump(2) + "\n";
        writeFileAtomically(*options.stats, std::as_bytes(std::span(text)));
    }
    if (interrupted())
        fmt::print(stderr, "eyeray: interrupted: {} whole samples are written\n", status->samples);
    if (status->counts.invalidSamples > 0)
        fmt::print(stderr, "eyeray: {} samples were not finite and count as black\n",
                   status->counts.invalidSamples);
    return 0;
}

}
