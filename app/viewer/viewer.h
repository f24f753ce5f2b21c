#pragma once
// The viewer without its window: the document, what renders it, and every command. The window, a headless
// snapshot and the command line drive it alike.

#include <chrono>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/history.h"
#include "app/document/picture_file.h"
#include "app/document/scene_files.h"
#include "app/viewer/background_job.h"
#include "app/viewer/bug_naming.h"
#include "app/viewer/chart_recording.h"
#include "app/viewer/comparison_rendering.h"
#include "app/viewer/grid_player.h"
#include "app/viewer/layer_rendering.h"
#include "app/viewer/needs_measuring.h"
#include "app/viewer/photon_rendering.h"
#include "app/viewer/pixel_study.h"
#include "app/viewer/player.h"
#include "core/render/render_session.h"

namespace eyeray {

struct PictureSize {
    int width = 0, height = 0; // pixels
    friend bool operator==(const PictureSize&, const PictureSize&) = default;
};

/// A line for the person in front: what has been done, or what went wrong. Errors stay until they are
/// dismissed.
struct Notice {
    enum class Kind : std::uint8_t { Done, Warning, Error } kind = Kind::Done;
    std::string text;
    std::chrono::steady_clock::time_point time;
};

/// The picture that the document is compared with.
struct OtherPicture {
    Camera camera;
    RenderSettings settings;
    EqualShare equal;
    friend bool operator==(const OtherPicture&, const OtherPicture&) = default;
};

/// Used by one thread. Nothing here waits for loading, building or tracing but finishJobs and
/// finishRendering.
class Viewer {
public:
    explicit Viewer(int threads = 0);

    /// Opens a scene and then applies the commands to it, as if the scene itself had asked for them.
    void openInBackground(const std::string& nameOrPath, std::vector<Command> commands);

    /// Shows a scene that has been opened already.
    void show(OpenedScene);

    /// Carries out any command of the language: those that change the document, and those of
    /// viewerCommands(). What goes wrong becomes a notice, and nothing else changes; false then. `gesture` as
    /// in History::change.
    bool execute(const Command&, const std::string& gesture = {});

    /// Takes over what jobs have finished and restarts rendering if the document or the picture's size have
    /// changed. To be called once a frame. True if something that a window shows may have changed.
    bool update();

    /// Size of the picture that is to be rendered.
    void setPictureSize(int width, int height);
    PictureSize pictureSize() const { return {width_, height_}; }

    /// Reloads the scene if its file has changed on disk since it was read; looks at most once a second.
    void watchFile();

    // what there is to show
    bool hasScene() const { return history_ != nullptr; }
    const Document& document() const { return history_->document(); }
    bool canUndo() const { return history_ && history_->canUndo(); }
    bool canRedo() const { return history_ && history_->canRedo(); }
    const OpenedScene& opened() const { return opened_; }
    bool loading() const { return loading_.running(); }
    const std::string& loadingName() const { return loadingName_; }
    bool building() const { return building_.running(); }
    std::shared_ptr<const World> world() const { return world_; }
    RenderSession& session() { return *session_; }
    /// What the picture that is shown, and hence the picked sample, is of: after an edit the former World for
    /// a moment. Null if there is no picture.
    std::shared_ptr<const World> shownWorld() const { return session_->shownWorld(); }
    const RenderSession& session() const { return *session_; }
    RenderStatus status() const { return session_->status(); }
    bool paused() const { return paused_; }
    const std::optional<PickedSample>& picked() const { return picked_; }
    /// Index of the ray of the picked sample that all views mark; 0, the eye ray, if nothing else is
    /// selected.
    int selectedRay() const;
    const Player& player() const { return player_; }
    const GridPlayer& gridPlayer() const { return grid_; }
    /// True while the one of them that is shown runs by itself.
    bool playing() const;
    /// The picked sample's ledger and tree, as they are looked at. Valid while there is a picked sample.
    const PixelStudy& study() const { return study_; }
    const LayerRendering& layers() const { return layers_; }
    /// The layer shown, as it stands: samples are those of the picture itself. Nothing as long as there is
    /// none.
    std::optional<LayerImage> layerImage() const;
    const ComparisonRendering& comparison() const { return comparison_; }
    const BugNaming& naming() const { return naming_; }
    const NeedsMeasuring& needs() const { return needs_; }
    /// Whether the document is as it was when its needs were measured, or as that has made it.
    bool needsHold() const;
    bool needsApplied() const;
    const PhotonRendering& photons() const { return photons_; }
    const PhotonSettings& photonSettings() const { return photonSettings_; }
    ChartRecording& recording() { return recording_; }
    const ChartRecording& recording() const { return recording_; }
    const std::deque<Notice>& notices() const { return notices_; }
    /// True while there is a notice that will go by itself.
    bool noticesPass() const;

    // what viewerCommands() do
    void startLoading(const std::string& nameOrPath, bool keepView);
    void undo() { history_->undo(); }
    void redo() { history_->redo(); }
    void reset() { history_->change(history_->original()); }
    /// Draws the error of each picture over time; the picture begins anew, so that it is drawn whole.
    void setRecording(bool on);
    /// Brings back what a curve of the chart was recorded with; one step of undo.
    void returnTo(std::size_t curve);
    void setPaused(bool);
    /// Picks a pixel of the picture, or none; selects the object there if asked. While a coarse picture is
    /// played, it plays up to that place.
    void pick(std::optional<PixelPosition>, bool select);
    /// Shows another sample of the picked pixel, from 0.
    void chooseSample(int sample);
    void selectRay(int ray) { selectedRay_ = ray; }
    /// One step of the playing of the picked sample, or its running; selects the ray that it comes to. Or of
    /// the coarse picture: picks the pixel that it comes to.
    void play(PlayTo);
    void runPlay(bool on);
    void setPlaySpeed(double factor);
    /// Plays a picture of few pixels from now on, and begins with none; or the picked sample again.
    void playGrid(bool on);
    void setStudy(const StudySettings&);
    /// Strikes a node of the picked sample's ledger out, or back in.
    void strike(int node, bool out) { study_.strike(node, out); }
    void restoreStruck() { study_.restore(); }
    /// Sends photons from the lamps, or stops.
    void setPhotons(const PhotonSettings& settings) { photonSettings_ = settings; }
    /// What OpenGL draws of the document while its picture is compared with that; null while it is not.
    void compareWith(std::shared_ptr<const ColorImage> rasterised);
    /// Shows the difference of a comparison, or takes it away; without one, what the last switch of a ray
    /// kind has changed. Throws InputError if none has been switched.
    void toggleDifference();
    /// Looks which fault explains a picture of the scene shown; then compares with that fault and picks the
    /// first wrong pixel. Throws InputError if the picture cannot be read.
    void nameBug(const std::filesystem::path& picture);
    /// Measures what the picture needs, in the background.
    void measureNeeds();
    /// Makes the picture with no more than it needs, as one step of undo; once that is measured. Then looks
    /// at the whole picture, in the background, and takes back what fails.
    void applyNeeds();
    void report(Notice::Kind, std::string text);
    void dismissNotice(std::size_t index);
    /// Ends a drag: the next change is a step of its own for undo.
    void endGesture();

    /// What a picture of the present document says about its making.
    PictureState pictureState() const;

    /// The edited scene with the present view as its first camera and settings.
    Scene sceneToSave() const;

    /// Waits until loading and building have ended and update() has taken their results.
    void finishJobs();
    /// Waits until the picture is finished or has `samples` whole passes.
    void finishRendering(int samples);

private:
    void change(Document, const std::string& gesture);
    bool takeLoaded();
    AccelKind wantedIndex() const;
    bool mustBuild() const;
    void startBuilding();
    bool takeBuilt();
    bool startRendering();
    std::optional<OtherPicture> otherPicture() const;
    void startComparison(const RenderSettings& now, const std::optional<std::string>& switched);
    bool updateComparison();
    bool updateLayer();
    bool updatePhotons();
    bool updateNaming();
    bool updateNeeds();
    void applyMeasured();
    void reportChecked(const MeasuredNeeds& before);
    bool tracing(int samples) const;
    bool meterExposure();
    void pickPixel(std::optional<PixelPosition>);
    void traceAgain();
    GridPlayer::Trace gridTrace() const;
    void pickGridCell();
    bool updatePlay();
    void retraceGrid();
    Document fileDocument() const;

    std::unique_ptr<History> history_; // none before the first scene
    OpenedScene opened_;
    std::filesystem::file_time_type fileTime_;
    std::chrono::steady_clock::time_point lastWatched_;

    BackgroundJob<OpenedScene> loading_;
    std::string loadingName_;
    bool keepView_ = false; // of the load under way: a reload keeps camera and settings
    BackgroundJob<std::shared_ptr<const World>> building_;
    std::shared_ptr<const World> world_;
    std::shared_ptr<const Scene> builtScene_; // what the last build was started for
    AccelKind builtIndex_ = AccelKind::Auto;

    std::unique_ptr<RenderSession> session_;
    int threads_; // as told at the start; a document may ask for others
    int sessionThreads_;
    std::optional<RenderSettings> rendered_; // what the session was last started with
    Camera renderedCamera_;
    std::shared_ptr<const World> renderedWorld_;
    int width_ = 0, height_ = 0;
    LayerRendering layers_;
    ComparisonRendering comparison_;
    PhotonRendering photons_;
    BugNaming naming_;
    NeedsMeasuring needs_;
    bool applyNeeds_ = false; // as soon as they are known
    PhotonSettings photonSettings_;
    ChartRecording recording_;
    std::optional<OtherPicture> compared_;         // what the comparison was last started with
    std::shared_ptr<const ColorImage> rasterised_; // likewise
    std::string lastSwitch_;                       // the setting that undoes it, such as "reflections=on"
    bool paused_ = false;
    bool meter_ = false; // the exposure is to be metered from the first picture

    std::optional<PickedSample> picked_;
    PixelStudy study_;
    int sample_ = 0, selectedRay_ = 0;
    Player player_;
    GridPlayer grid_;
    std::deque<Notice> notices_;
    RenderStatus::Phase lastPhase_ = RenderStatus::Phase::Idle; // at the last update
    int lastSamples_ = 0;
};

}
