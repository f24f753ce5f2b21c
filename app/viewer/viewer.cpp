#include "app/viewer/viewer.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/document/document_commands.h"
#include "app/document/saved_scene.h"
#include "app/viewer/switched_kind.h"
#include "app/viewer/viewer_commands.h"
#include "core/base/errors.h"
#include "core/scene/choose_index.h"

namespace eyeray {
namespace {

constexpr std::size_t kMostNotices = 8;
constexpr auto kShortWait = std::chrono::milliseconds(5);
constexpr auto kNoticeShown = std::chrono::seconds(6); // errors stay until they are dismissed
constexpr auto kWatchInterval = std::chrono::seconds(1);

}

Viewer::Viewer(int threads)
    : session_(std::make_unique<RenderSession>(threads)), threads_(threads), sessionThreads_(threads) {}

bool Viewer::execute(const Command& command, const std::string& gesture) {
    try {
        if (isDocumentCommand(command.name())) {
            if (!hasScene()) throw InputError(command.text(), "no scene is open", "open a scene first");
            change(apply(document(), command), gesture);
        } else {
            executeViewerCommand(*this, command);
        }
    } catch (const std::exception& error) {
        report(Notice::Kind::Error, error.what());
        return false;
    }
    return true;
}

void Viewer::change(Document changed, const std::string& gesture) {
    const Document& now = document();
    const bool onlySelected = changed.scene == now.scene && commandsBetween(now, changed).empty();
    if (onlySelected)
        history_->replace(std::move(changed));
    else
        history_->change(std::move(changed), gesture);
}

void Viewer::pick(std::optional<PixelPosition> pixel, bool select) {
    if (pixel && grid_.on()) {
        const PixelGrid& grid = grid_.grid();
        grid_.goTo(grid.cellAt(std::min(pixel->x, grid.width - 1), std::min(pixel->y, grid.height - 1)) + 1,
                   gridTrace());
        pickGridCell();
    } else {
        pickPixel(pixel);
    }
    if (!select || !picked_) return;
    Document selected = document();
    selected.selectedObject = picked_->object;
    history_->replace(std::move(selected));
}

void Viewer::pickPixel(std::optional<PixelPosition> pixel) {
    Document picked = document();
    if (picked.pixel != pixel) {
        selectedRay_ = 0;
        player_.reset();
    }
    picked.pixel = pixel;
    history_->replace(std::move(picked));
    traceAgain();
}

void Viewer::traceAgain() {
    picked_.reset();
    if (!hasScene() || !document().pixel) return;
    const PixelPosition pixel = *document().pixel;
    auto trace = session_->retrace(pixel.x, pixel.y, sample_);
    if (!trace) return;
    int object = trace->rays.empty() ? -1 : trace->rays.front().object;
    // the picture may still be that of the scene before
    if (object >= static_cast<int>(document().scene->objects.size())) object = -1;
    picked_ = PickedSample{pixel, sample_, std::move(*trace), object};
    study_.look(*picked_, *document().scene);
}

void Viewer::setStudy(const StudySettings& settings) {
    study_.set(settings);
    if (picked_) study_.look(*picked_, *document().scene);
}

void Viewer::chooseSample(int sample) {
    sample_ = sample;
    player_.reset();
    retraceGrid();
    traceAgain();
}

int Viewer::selectedRay() const {
    return picked_ && selectedRay_ < static_cast<int>(picked_->trace.rays.size()) ? selectedRay_ : 0;
}

void Viewer::setPictureSize(int width, int height) {
    if (hasScene() && document().pixel && height_ > 0 && (width != width_ || height != height_)) {
        // the picked pixel stays on what it shows: the field of view is vertical, about the middle
        const double larger = static_cast<double>(height) / height_;
        const auto kept = [&](int place, int before, int now) {
            const double fromMiddle = (place + 0.5 - 0.5 * before) * larger;
            return std::clamp(static_cast<int>(std::floor(0.5 * now + fromMiddle)), 0, std::max(0, now - 1));
        };
        Document moved = document();
        moved.pixel =
            PixelPosition{kept(moved.pixel->x, width_, width), kept(moved.pixel->y, height_, height)};
        history_->replace(std::move(moved));
        picked_.reset();
    }
    width_ = width;
    height_ = height;
}

void Viewer::setPaused(bool paused) {
    paused_ = paused;
    paused ? session_->pause() : session_->resume();
    comparison_.setPaused(paused);
    photons_.setPaused(paused);
}

bool Viewer::update() {
    std::erase_if(notices_, [now = std::chrono::steady_clock::now()](const Notice& notice) {
        return notice.kind != Notice::Kind::Error && now - notice.time > kNoticeShown;
    });
    const bool loaded = takeLoaded();
    const bool built = takeBuilt();
    if (!hasScene()) return loaded || loading();
    bool started = false;
    if (built && history_->inGesture())
        started = startRendering(); // before the next step of the drag is built
    if (mustBuild()) startBuilding();
    started |= startRendering();
    const bool metered = meterExposure();
    const bool compared = updateComparison(), layered = updateLayer(), lit = updatePhotons();
    const bool charted = recording_.update(*session_);
    const bool named = updateNaming(), needed = updateNeeds();
    const RenderStatus now = session_->status();
    const bool finished = lastPhase_ != now.phase || lastSamples_ != now.samples;
    if (now.phase != lastPhase_) retraceGrid();
    if (document().pixel && (!picked_ || now.phase != lastPhase_)) traceAgain();
    const bool played = updatePlay();
    const bool averaged = picked_ && study_.average(*session_, picked_->pixel);
    lastPhase_ = now.phase;
    lastSamples_ = now.samples;
    return loaded || built || started || metered || compared || layered || finished || averaged || played ||
           lit || charted || named || needed || now.active() || loading() || building();
}

void Viewer::openInBackground(const std::string& nameOrPath, std::vector<Command> commands) {
    loadingName_ = nameOrPath;
    keepView_ = false;
    loading_.start([nameOrPath, commands = std::move(commands)](const std::stop_token& stop) {
        OpenedScene opened = openScene(nameOrPath, stop);
        applyTo(opened, commands);
        return opened;
    });
}

void Viewer::startLoading(const std::string& nameOrPath, bool keepView) {
    loadingName_ = nameOrPath;
    keepView_ = keepView;
    loading_.start([nameOrPath](const std::stop_token& stop) { return openScene(nameOrPath, stop); });
}

bool Viewer::takeLoaded() {
    std::optional<OpenedScene> opened;
    try {
        opened = loading_.take();
    } catch (const std::exception& error) {
        report(Notice::Kind::Error, error.what());
        return true;
    }
    if (!opened) return false;
    show(std::move(*opened));
    return true;
}

void Viewer::show(OpenedScene opened) {
    opened_ = std::move(opened);
    std::error_code error;
    fileTime_ = std::filesystem::last_write_time(opened_.path, error);
    std::optional<Document> kept;
    if (keepView_ && hasScene() && opened_.document.lab == nullptr) {
        kept = document();
        kept->scene = opened_.document.scene;
        kept->selectedObject = -1;
    }
    keepView_ = false;
    meter_ = opened_.meterExposure && !kept;
    history_ = std::make_unique<History>(opened_.document);
    recording_.clear();
    if (kept) history_->change(std::move(*kept));
    picked_.reset();
    grid_.end();
    naming_.clear();
    needs_.clear();
    int changes = 0;
    for (const auto& line : opened_.report.lines) changes += line.kind != ImportReport::Kind::Added ? 1 : 0;
    if (changes > 0)
        report(Notice::Kind::Warning,
               fmt::format("{}: {} parts of the file are not shown as it says: see the import report",
                           opened_.reference, changes));
}

AccelKind Viewer::wantedIndex() const { return chooseIndex(*document().scene, buildSettings(document())); }

/// Also once a drag has ended that a refitted World has followed: what rays visit never tells how one came
/// there. While one goes on, each World is finished and shown, else a drag that moves in every frame would
/// show none.
bool Viewer::mustBuild() const {
    const bool changed = document().scene != builtScene_ || wantedIndex() != builtIndex_;
    if (building()) return changed && !history_->inGesture();
    return changed || (world_ && world_->refitted && !history_->inGesture());
}

void Viewer::startBuilding() {
    builtScene_ = document().scene;
    builtIndex_ = wantedIndex();
    session_->giveWay(); // what it traces will not be shown
    building_.start([scene = builtScene_, settings = BuildSettings{builtIndex_}, previous = world_,
                     refits = history_->inGesture()](const std::stop_token& stop) {
        return refits && previous ? refitWorld(scene, settings, *previous, stop)
                                  : buildWorld(scene, settings, previous.get(), stop);
    });
}

bool Viewer::takeBuilt() {
    try {
        auto built = building_.take();
        if (!built || !*built) return false;
        world_ = std::move(*built);
        return true;
    } catch (const std::exception& error) {
        world_ = nullptr;
        session_->goOn();
        report(Notice::Kind::Error, error.what());
        return true;
    }
}

bool Viewer::startRendering() {
    if (!world_ || width_ <= 0 || height_ <= 0 || building()) return false;
    const int threads = document().threads > 0 ? document().threads : threads_;
    RenderSettings settings = document().render;
    settings.width = width_;
    settings.height = height_;
    RenderSettings shown = settings; // how the picture is displayed changes nothing of the tracing
    if (rendered_) shown.display = rendered_->display;
    const bool samePlace = renderedWorld_ == world_ && renderedCamera_ == document().camera;
    const bool same = rendered_ == shown && samePlace && sessionThreads_ == threads;
    const std::optional<OtherPicture> other = otherPicture();
    if (same && other == compared_) return false;
    const bool endsComparison = same && !other;
    compared_ = other;
    if (endsComparison) {
        comparison_.stop(*session_);
        return true;
    }
    if (sessionThreads_ != threads) {
        session_ = std::make_unique<RenderSession>(threads);
        sessionThreads_ = threads;
        if (paused_) session_->pause();
    }
    renderedWorld_ = world_;
    renderedCamera_ = document().camera;
    startComparison(settings, samePlace && rendered_ ? switchedKind(*rendered_, settings) : std::nullopt);
    rendered_ = settings;
    // side by side with as many samples, each pixel has as many
    if (compared_ && compared_->equal == EqualShare::Samples) settings.stop.adaptive = false;
    session_->start(world_, document().camera, settings);
    recording_.begin(history_->original(), document(), width_, height_);
    picked_.reset();
    return true;
}

bool Viewer::meterExposure() {
    if (!meter_ || session_->status().samples < 1) return false;
    meter_ = false;
    const ColorImage image = session_->image();
    if (image.empty()) return false;
    const double exposure = std::clamp(std::round(meteredExposure(image) * 10) / 10, -20.0, 20.0);
    const Command command("set", {{"exposure", toText(exposure)}});
    const bool edited = canUndo();
    const Document metered = apply(document(), command);
    opened_.document = apply(opened_.document, command);
    history_ = std::make_unique<History>(edited ? opened_.document : metered);
    if (edited) history_->change(metered);
    report(Notice::Kind::Done, fmt::format("exposure metered once from the first picture: {} EV", exposure));
    return true;
}

void Viewer::watchFile() {
    const auto now = std::chrono::steady_clock::now();
    if (!hasScene() || loading() || now - lastWatched_ < kWatchInterval) return;
    lastWatched_ = now;
    std::error_code error;
    const auto time = std::filesystem::last_write_time(opened_.path, error);
    if (error || time == fileTime_) return;
    fileTime_ = time;
    startLoading(opened_.reference, true);
    report(Notice::Kind::Done, fmt::format("{} has changed on disk: loaded again", opened_.reference));
}

void Viewer::report(Notice::Kind kind, std::string text) {
    notices_.push_back({kind, std::move(text), std::chrono::steady_clock::now()});
    if (notices_.size() > kMostNotices) notices_.pop_front();
}

bool Viewer::noticesPass() const {
    return std::any_of(notices_.begin(), notices_.end(),
                       [](const Notice& notice) { return notice.kind != Notice::Kind::Error; });
}

void Viewer::dismissNotice(std::size_t index) {
    if (index < notices_.size()) notices_.erase(notices_.begin() + static_cast<std::ptrdiff_t>(index));
}

void Viewer::setRecording(bool on) {
    if (on && !recording_.on()) rendered_.reset();
    recording_.setOn(on);
}

void Viewer::returnTo(std::size_t curve) {
    Document back = recording_.curves().at(curve).document;
    back.pixel = document().pixel;
    change(std::move(back), {});
}

PictureState Viewer::pictureState() const {
    PictureState state{opened_.reference, opened_.sha256, {}};
    for (const Command& command : commandsBetween(fileDocument(), document()))
        state.commands.push_back(command.text());
    return state;
}

Scene Viewer::sceneToSave() const { return savedScene(document()); }

Document Viewer::fileDocument() const { return originalOf(opened_.document); }

void Viewer::finishJobs() {
    do {
        loading_.wait();
        building_.wait();
        update();
    } while (loading() || building());
}

void Viewer::finishRendering(int samples) {
    finishJobs();
    if (!hasScene()) return;
    while (tracing(samples)) {
        std::this_thread::sleep_for(kShortWait);
        finishJobs();
    }
    update();
}

void Viewer::endGesture() {
    if (history_) history_->endGesture();
}

}
