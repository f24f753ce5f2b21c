#include "app/gui/gui_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/document/user_folders.h"
#include "app/gui/gui.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

using namespace std::string_view_literals;

constexpr std::array kDialogNames = {"none"sv, "open"sv, "save"sv, "help"sv, "report"sv, "name-bug"sv};

bool wanted(const Command& command, bool now) {
    command.allowOnly({"on"});
    return command.flag("on").value_or(!now);
}

void dialog(Gui& gui, const Command& command) {
    command.allowOnly({"show"});
    command.required("show");
    gui.show(static_cast<Dialog>(*command.choice("show", kDialogNames)));
}

void theme(Gui& gui, const Command& command) {
    constexpr std::array kNames = {"dark"sv, "light"sv};
    command.allowOnly({"name"});
    const auto name = command.choice("name", kNames);
    gui.setTheme(name ? *name == 0 : !gui.preferences().dark);
}

void presenter(Gui& gui, const Command& command) {
    gui.setPresenter(wanted(command, gui.preferences().presenter));
}
void panels(Gui& gui, const Command& command) { gui.setPanels(wanted(command, gui.preferences().panels)); }
void tab(Gui& gui, const Command& command) {
    constexpr std::array kNames = {"tree"sv, "sum"sv, "play"sv, "light"sv, "needs"sv, "chart"sv};
    constexpr std::array kLabels = {"Tree"sv, "Sum"sv, "Play"sv, "Light"sv, "Needs"sv, "Chart"sv};
    command.allowOnly({"name"});
    command.required("name");
    gui.showTab(kLabels[static_cast<std::size_t>(*command.choice("name", kNames))]);
}

/// Without the views that explain it the coarse picture would be a riddle.
void explain(Gui& gui, const Command& command) {
    gui.setExplain(wanted(command, gui.preferences().explain));
    if (!gui.preferences().explain) gui.viewer().playGrid(false);
}
void hover(Gui& gui, const Command& command) { gui.setHover(wanted(command, gui.preferences().hover)); }
void rasterised(Gui& gui, const Command& command) { gui.setRasterised(wanted(command, gui.rasterised())); }
/// Whoever wants boxes wants to see them.
void rayview(Gui& gui, const Command& command) {
    gui.rayPane().execute(command);
    if (command.find("boxes").value_or("none") != "none") gui.setExplain(true);
}
void other(Gui& gui, const Command& command) { gui.setOther(wanted(command, gui.other())); }
void fly(Gui& gui, const Command& command) { gui.setFly(wanted(command, gui.fly())); }
void fullscreen(Gui& gui, const Command& command) {
    gui.platform().setFullscreen(wanted(command, gui.platform().fullscreen()));
}
void quit(Gui& gui, const Command& command) {
    command.allowOnly({});
    gui.quit();
}

void windowScreenshot(Gui& gui, const Command& command) {
    command.allowOnly({"file"});
    const auto file = command.find("file");
    gui.saveWindow(file ? std::filesystem::path(*file) : freeName(picturesFolder(), "eyeray-window"));
}

void rayviewScreenshot(Gui& gui, const Command& command) {
    constexpr int kSmallest = 64, kLargest = 4096;
    command.allowOnly({"file", "width", "height"});
    const auto file = command.find("file");
    std::optional<PictureSize> size;
    if (command.find("width") || command.find("height")) {
        command.required("width");
        command.required("height");
        size = PictureSize{*command.integer("width", kSmallest, kLargest),
                           *command.integer("height", kSmallest, kLargest)};
    }
    gui.saveRays(file ? std::filesystem::path(*file) : freeName(picturesFolder(), "eyeray-rays"), size);
}

/// Whoever plays wants to see it.
void showPlay(Gui& gui, bool begun) {
    if (!gui.preferences().explain || !begun) gui.showTab("Play");
    gui.setExplain(true);
}

void play(Gui& gui, const Command& command) {
    constexpr double kSlowest = 0.05, kFastest = 100;
    command.allowOnly({"to", "run", "speed"});
    Viewer& viewer = gui.viewer();
    const auto& picked = viewer.picked();
    const bool onGrid = viewer.gridPlayer().on();
    if (const auto speed = command.number("speed", kSlowest, kFastest)) {
        viewer.setPlaySpeed(*speed);
        if (command.arguments().size() == 1) return;
    }
    if (!onGrid && (!picked || picked->trace.rays.empty()))
        throw InputError(command.text(), "there are no rays to play",
                         "click the picture, or say pick x=320 y=240");
    showPlay(gui, onGrid || viewer.player().begun());
    if (const auto to = command.choice("to", kPlayToNames)) {
        viewer.runPlay(false);
        viewer.play(static_cast<PlayTo>(*to));
    }
    if (!command.find("to") || command.find("run"))
        viewer.runPlay(command.flag("run").value_or(!viewer.playing()));
}

void playGrid(Gui& gui, const Command& command) {
    const bool on = wanted(command, gui.viewer().gridPlayer().on());
    if (on && !gui.viewer().hasScene())
        throw InputError(command.text(), "no scene is open", "open a scene first");
    gui.viewer().playGrid(on);
    if (on) showPlay(gui, false);
}

void fromLight(Gui& gui, const Command& command) {
    constexpr double kLongest = 1e6, kSlowest = 0.1; // metres; photons a second
    command.allowOnly({"on", "radius", "rate", "photons"});
    Viewer& viewer = gui.viewer();
    PhotonSettings settings = viewer.photonSettings();
    const bool wasOn = settings.on;
    settings.on = command.flag("on").value_or(!command.arguments().empty() || !wasOn);
    settings.radius = command.number("radius", 0, kLongest).value_or(settings.radius);
    settings.perSecond = command.number("rate", kSlowest, kMostPhotonsPerSecond).value_or(settings.perSecond);
    if (const auto most = command.number("photons", 0, kMostPhotons))
        settings.most = static_cast<std::uint64_t>(*most);
    if (settings.on && !viewer.hasScene())
        throw InputError(command.text(), "no scene is open", "open a scene first");
    viewer.setPhotons(settings);
    if (settings.on && !wasOn) {
        gui.showTab("Light");
        gui.setExplain(true);
    }
}

void chart(Gui& gui, const Command& command) {
    const bool on = wanted(command, gui.viewer().recording().on());
    if (on && !gui.viewer().hasScene())
        throw InputError(command.text(), "no scene is open", "open a scene first");
    gui.viewer().setRecording(on);
    if (!on) return;
    gui.showTab("Chart");
    gui.setExplain(true);
}

/// Measures them if they are not known.
void needs(Gui& gui, const Command& command) {
    command.allowOnly({});
    Viewer& viewer = gui.viewer();
    if (!viewer.hasScene()) throw InputError(command.text(), "no scene is open", "open a scene first");
    gui.showTab("Needs");
    gui.setExplain(true);
    if (!viewer.needs().running() && !viewer.needsHold() && !viewer.needsApplied()) viewer.measureNeeds();
}

void deselect(Gui& gui, const Command&) {
    if (gui.viewer().hasScene()) {
        gui.viewer().pick(std::nullopt, false);
        gui.execute({"select", {{"object", "none"}}});
    }
}

void movePixel(Gui& gui, const Command& command) {
    command.allowOnly({"x", "y"});
    if (!gui.viewer().hasScene()) return;
    const PictureSize size = gui.viewer().pictureSize();
    const auto& pixel = gui.viewer().document().pixel;
    const GridPlayer& player = gui.viewer().gridPlayer(); // its cells are the pixels then
    const auto moved = [&](std::string_view axis, int from, int count) {
        const int by = command.integer(axis, -kMaxPictureSide, kMaxPictureSide).value_or(0);
        const int cells = axis == "x" ? player.grid().columns : player.grid().rows;
        return std::clamp(from + (player.on() ? by * (count / cells) : by), 0, std::max(0, count - 1));
    };
    gui.viewer().pick(PixelPosition{moved("x", pixel ? pixel->x : size.width / 2, size.width),
                                    moved("y", pixel ? pixel->y : size.height / 2, size.height)},
                      false);
}

void frameSelected(Gui& gui, const Command&) {
    if (!gui.viewer().hasScene()) return;
    const int object = gui.viewer().document().selectedObject;
    if (object < 0) throw InputError("frame-selected", "no object is selected", "click one first");
    gui.execute({"frame", {{"object", fmt::format("{}", object)}}});
}

void nextCamera(Gui& gui, const Command&) {
    if (!gui.viewer().hasScene()) return;
    const Document& document = gui.viewer().document();
    const auto& cameras = document.scene->cameras;
    const auto now = std::find_if(cameras.begin(), cameras.end(),
                                  [&](const Camera& camera) { return camera.name == document.camera.name; });
    const auto index = static_cast<std::size_t>(now - cameras.begin() + 1) % cameras.size();
    gui.execute({"camera", {{"camera", fmt::format("{}", index)}}});
}

constexpr std::array kCommands = {
    GuiCommand{"dialog", "show=open|save|help|report|name-bug|none", "Shows a dialog.", dialog},
    GuiCommand{"window-screenshot", "file=FILE.png", "Saves the whole window.", windowScreenshot},
    GuiCommand{"rayview-screenshot", "file=FILE.png|.svg width=N height=N",
               "Saves the rays in space; in an SVG they are vectors.", rayviewScreenshot},
    GuiCommand{"theme", "name=dark|light", "Chooses the theme.", theme},
    GuiCommand{"presenter", "on=on|off", "Large text for the back row.", presenter},
    GuiCommand{"panels", "on=on|off", "Shows or hides the panels.", panels},
    GuiCommand{"explain", "on=on|off", "Shows the picked pixel's rays in space, its tree and its sum.",
               explain},
    GuiCommand{"hover", "on=on|off", "Tells of the pixel under the pointer, and shows its rays.", hover},
    GuiCommand{"rayview",
               "view=frame|follow|top|side|front yaw=DEG pitch=DEG right=M up=M dolly=F "
               "show=pixel|row|column|grid step=N labels=on|off boxes=none|level|ray level=N",
               "Moves the outside camera; chooses whose rays and which boxes of the index are drawn.",
               rayview},
    GuiCommand{"rasterised", "on=on|off",
               "Shows what OpenGL draws of the scene: no shadows, mirrors or glass.", rasterised},
    GuiCommand{"tab", "name=tree|sum|play|light|needs|chart",
               "Shows the picked pixel's tree, its sum or its playing, the photons, the needs or the chart.",
               tab},
    GuiCommand{"play", "to=start|back|next|hit|light|end run=on|off speed=F",
               "Plays how the picked pixel is traced, or the coarse picture: a step, or by itself.", play},
    GuiCommand{"play-grid", "on=on|off",
               "Plays how a picture of 16 by 12 pixels is traced, one pixel at a step.", playGrid},
    GuiCommand{"from-light", "on=on|off radius=M rate=N photons=N",
               "Sends photons from the lamps; how large the lens is, how many a second, how many in all.",
               fromLight},
    GuiCommand{"chart", "on=on|off", "Draws time against error of each picture while it refines.", chart},
    GuiCommand{"needs", "", "Shows what the picture needs and what it does not.", needs},
    GuiCommand{"other", "on=on|off", "Shows the picture in place of a layer, or the other side alone.",
               other},
    GuiCommand{"fullscreen", "on=on|off", "Fills the screen.", fullscreen},
    GuiCommand{"fly", "on=on|off", "W A S D Q E move the eye.", fly},
    GuiCommand{"deselect", "", "Selects no object and no pixel.", deselect},
    GuiCommand{"move-pixel", "x=DX y=DY", "Moves the picked pixel.", movePixel},
    GuiCommand{"frame-selected", "", "Frames the selected object.", frameSelected},
    GuiCommand{"next-camera", "", "Goes to the scene's next camera.", nextCamera},
    GuiCommand{"quit", "", "Ends the program.", quit},
};

}

std::span<const GuiCommand> guiCommands() { return kCommands; }

}
