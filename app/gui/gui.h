#pragma once
// The window's content: picture, panels, menus. Drawn anew each frame from the viewer; everything it does is
// a command.

#include <map>
#include <optional>
#include <string>

#include "app/gui/chart_view.h"
#include "app/gui/file_dialog.h"
#include "app/gui/picture_view.h"
#include "app/gui/preferences.h"
#include "app/gui/ray_pane.h"
#include "app/gui/widgets.h"
#include "app/platform/platform.h"
#include "app/viewer/viewer.h"

namespace eyeray {

enum class Dialog : std::uint8_t { None, Open, Save, Help, Report, NameBug };

/// Used by the thread of the platform.
class Gui {
public:
    Gui(Viewer&, Platform&, Preferences);

    /// Takes dropped files, brings the viewer up to date and draws one frame, all between the platform's
    /// beginFrame and endFrame.
    void frame();

    /// What can only be done once a frame is whole: window screenshots.
    void afterFrame();

    /// Carries out any command: those of guiCommands(), else the viewer's. False, with a notice, if it went
    /// wrong.
    bool execute(const Command&, const std::string& gesture = {});

    /// True if the next frame may differ from the last without input.
    bool animating() const { return animating_; }

    bool quitAsked() const { return quit_; }
    Preferences& preferences() { return preferences_; }

    /// Rectangles of the last frame's widgets by name: "shadows", "max-depth", "picture", "menu File".
    const std::map<std::string, WidgetRect>& widgets() const { return widgets_; }

    // what guiCommands() do
    Viewer& viewer() { return viewer_; }
    Platform& platform() { return platform_; }
    void show(Dialog);
    void quit() { quit_ = true; }
    void setTheme(bool dark);
    void setPresenter(bool);
    void setPanels(bool shown) { preferences_.panels = shown; }
    void setExplain(bool on) { preferences_.explain = on; }
    void setHover(bool);
    /// Brings the tab of this label to the front, with the next frame.
    void showTab(std::string_view label) { wantedTab_ = label; }
    void setRasterised(bool on) { picture_.setRasterised(on); }
    bool rasterised() const { return picture_.rasterised(); }
    RayPane& rayPane() { return rayPane_; }
    const PictureView& picture() const { return picture_; }
    void setFly(bool on) { fly_ = on; }
    bool fly() const { return fly_; }
    void saveRays(std::filesystem::path file, std::optional<PictureSize> size) {
        raysFile_ = {std::move(file), size};
    }
    void setOther(bool shown) { other_ = shown; }
    bool other() const { return other_; }
    void saveWindow(std::filesystem::path file) { windowFile_ = std::move(file); }

private:
    void keys();
    void flyKeys();
    void menuBar(const Widgets&);
    void recentMenu(const Widgets&);
    void middle(const Widgets&, ImVec2 at, ImVec2 size);
    void explainingTabs(const Widgets&);
    void panels(const Widgets&);
    void writeRays(const Widgets&);
    void dialog(const Widgets&);
    void fileDialog(const Widgets&);

    Viewer& viewer_;
    Platform& platform_;
    Preferences preferences_;
    PictureView picture_;
    RayPane rayPane_;
    ChartView chart_;
    FileDialog files_;
    std::map<std::string, WidgetRect> widgets_;
    Dialog dialog_ = Dialog::None;
    std::string_view wantedTab_;
    bool charts_ = false; // the tab of the chart is open: it stands in the place of the rays in space
    bool fly_ = false, other_ = false, quit_ = false, animating_ = true;
    struct RaysFile {
        std::filesystem::path file;
        std::optional<PictureSize> size;
    };
    std::optional<RaysFile> raysFile_; // the rays in space are to be written here at the end of this frame
    std::optional<std::filesystem::path>
        windowFile_; // a window screenshot is to be written here after this frame
};

}
