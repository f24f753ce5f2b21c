#include "app/gui/gui.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "app/gui/actions.h"
#include "app/gui/dialogs.h"
#include "app/gui/gui_commands.h"
#include "app/gui/layout.h"
#include "app/gui/panels.h"
#include "app/gui/theme.h"
#include "app/platform/input.h"
#include "app/platform/keys.h"
#include "core/image/atomic_file.h"
#include "core/image/encode.h"

namespace eyeray {
namespace {

constexpr float kPresenterScale = 1.6F;
constexpr float kPanelWidth = 23;        // in letters' heights
constexpr float kLeastPicture = 0.55F;   // of the window's width; panels give way
constexpr float kLeastExplained = 0.61F; // likewise, with the views that explain

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs;

}

Gui::Gui(Viewer& viewer, Platform& platform, Preferences preferences)
    : viewer_(viewer), platform_(platform), preferences_(std::move(preferences)), picture_(platform.gl()),
      rayPane_(platform.gl()), chart_(platform.gl()) {
    setTheme(preferences_.dark);
    setPresenter(preferences_.presenter);
    setHover(preferences_.hover);
}

void Gui::setTheme(bool dark) {
    preferences_.dark = dark;
    platform_.setStyle(themeStyle(dark));
}

void Gui::setPresenter(bool on) {
    preferences_.presenter = on;
    platform_.setTextScale(on ? kPresenterScale : 1.0F);
}

void Gui::setHover(bool on) {
    preferences_.hover = on;
    picture_.setHover(on);
}

bool Gui::execute(const Command& command, const std::string& gesture) {
    animating_ = true;
    for (const GuiCommand& known : guiCommands()) {
        if (known.name != command.name()) continue;
        try {
            known.run(*this, command);
        } catch (const std::exception& error) {
            viewer_.report(Notice::Kind::Error, error.what());
            return false;
        }
        return true;
    }
    return viewer_.execute(command, gesture);
}

void Gui::frame() {
    for (const auto& file : platform_.takeDroppedFiles()) execute({"open", {{"scene", file.string()}}});
    if (viewer_.hasScene() && !viewer_.loading()) preferences_.remember(lastingReference(viewer_.opened()));
    widgets_.clear();
    const Widgets ui{
        viewer_, preferences_.dark, platform_.scale(),
        [this](const Command& command, const std::string& gesture) { return execute(command, gesture); },
        widgets_};
    keys();
    menuBar(ui);

    const ImGuiViewport& window = *ImGui::GetMainViewport();
    const float status = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().WindowPadding.y;
    const float wantedPanels = preferences_.panels ? ImGui::GetFontSize() * kPanelWidth : 0;
    const float panelWidth = std::min(
        wantedPanels, window.WorkSize.x * (1 - (preferences_.explain ? kLeastExplained : kLeastPicture)));
    const ImVec2 origin = window.WorkPos, size = window.WorkSize;

    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::SetNextWindowPos({origin.x, origin.y + size.y - status});
    ImGui::SetNextWindowSize({size.x, status});
    ImGui::Begin("status", nullptr, kFixed | ImGuiWindowFlags_NoScrollbar);
    statusBar(ui);
    ImGui::End();
    if (panelWidth > 0) {
        ImGui::SetNextWindowPos({origin.x + size.x - panelWidth, origin.y});
        ImGui::SetNextWindowSize({panelWidth, size.y - status});
        ImGui::Begin("panels", nullptr, kFixed | ImGuiWindowFlags_AlwaysVerticalScrollbar);
        panels(ui);
        ImGui::End();
    }
    middle(ui, origin, {size.x - panelWidth, size.y - status});
    ImGui::PopStyleVar();

    noticesOverlay(ui, origin.x + size.x - panelWidth - ImGui::GetFontSize(),
                   origin.y + ImGui::GetFontSize());
    dialog(ui);
    if (raysFile_) writeRays(ui);
    viewer_.watchFile();
    animating_ = viewer_.update() || fly_ || viewer_.noticesPass() || picture_.hover().pending();
}

/// The picture and, if asked for, what explains it.
void Gui::middle(const Widgets& ui, ImVec2 at, ImVec2 size) {
    constexpr ImGuiWindowFlags kStill =
        kFixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    const auto begin = [](const char* name, const Area& area, ImGuiWindowFlags flags) {
        ImGui::SetNextWindowPos(area.at);
        ImGui::SetNextWindowSize(area.size);
        ImGui::Begin(name, nullptr, flags);
    };
    rayPane_.noticeScene(viewer_);
    const ExplainLayout layout = preferences_.explain ? explainLayout({at, size}, ImGui::GetFontSize())
                                                      : ExplainLayout{{at, size}, {}, {}};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    begin("picture", layout.picture, kStill);
    picture_.draw(ui, other_);
    ImGui::End();
    ImGui::PopStyleVar();
    if (layout.rays) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {6 * ui.scale, 4 * ui.scale});
        begin("rays", *layout.rays, kStill);
        if (charts_)
            chart_.plot(ui);
        else
            rayPane_.draw(ui, picture_);
        ImGui::End();
        ImGui::PopStyleVar();
    }
    if (layout.words) {
        begin("words", *layout.words, kFixed);
        explainingTabs(ui);
        ImGui::End();
    }
}

/// The picked pixel in words and numbers.
void Gui::explainingTabs(const Widgets& ui) {
    if (!viewer_.hasScene() || !ImGui::BeginTabBar("explain")) return;
    struct Tab {
        const char* label;
        std::function<void()> draw;
    };
    const auto view = [&](void (*draw)(const Widgets&)) { return [&ui, draw] { draw(ui); }; };
    for (const Tab& tab : {Tab{"Tree", view(treeView)}, Tab{"Sum", view(ledgerView)},
                           Tab{"Play", view(playView)}, Tab{"Light", view(photonView)},
                           Tab{"Needs", view(needsView)}, Tab{"Chart", [&] { chart_.list(ui); }}}) {
        const bool wanted = wantedTab_ == tab.label;
        const bool open = ImGui::BeginTabItem(tab.label, nullptr, wanted ? ImGuiTabItemFlags_SetSelected : 0);
        ui.mark(fmt::format("tab {}", tab.label));
        if (!open) continue;
        charts_ = std::string_view(tab.label) == "Chart";
        tab.draw();
        ImGui::EndTabItem();
    }
    wantedTab_ = {};
    ImGui::EndTabBar();
}

void Gui::panels(const Widgets& ui) {
    if (panelHeading(ui, "Scene")) scenePanel(ui);
    if (!viewer_.hasScene()) return;
    if (panelHeading(ui, "Failure lab", viewer_.document().lab != nullptr)) labPanel(ui);
    if (panelHeading(ui, "Rays")) raysPanel(ui);
    if (panelHeading(ui, "Camera")) cameraPanel(ui);
    if (panelHeading(ui, "Object")) objectPanel(ui);
    if (panelHeading(ui, "Picked pixel")) pixelPanel(ui);
    if (panelHeading(ui, "Lamps and sky", false)) lightsPanel(ui);
    if (panelHeading(ui, "Display")) displayPanel(ui);
    if (panelHeading(ui, "Compare", false)) comparePanel(ui);
}

void Gui::keys() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    if (fly_) flyKeys();
    if (ImGui::IsKeyPressed('O', false)) execute({"other", {{"on", "on"}}});
    if (ImGui::IsKeyReleased('O')) execute({"other", {{"on", "off"}}});
    for (const Action& action : actions()) {
        if (action.chord.empty()) continue;
        const KeyChord chord = parseKeyChord(action.chord);
        const bool letter = chord.key >= 'A' && chord.key <= 'Z';
        if (fly_ && letter && !chord.ctrl && action.command != "fly") continue;
        if (!pressed(chord, action.menu.empty())) continue;
        if (chord.key == kKeyEscape && dialog_ != Dialog::None)
            show(Dialog::None);
        else
            execute(Command::parse(action.command));
    }
}

void Gui::flyKeys() {
    if (!viewer_.hasScene()) return;
    struct Move {
        int key;
        const char* axis;
        double sign;
    };
    const double speed = 0.6 * boundsOf(*viewer_.document().scene).radius(); // metres per second
    const double step = speed * std::min(0.1, static_cast<double>(ImGui::GetIO().DeltaTime));
    for (const Move& move : {Move{'W', "forward", 1},
                             {'S', "forward", -1},
                             {'D', "right", 1},
                             {'A', "right", -1},
                             {'E', "up", 1},
                             {'Q', "up", -1}})
        if (ImGui::IsKeyDown(move.key)) execute({"pan", {{move.axis, toText(move.sign * step)}}}, "fly");
}

void Gui::menuBar(const Widgets& ui) {
    if (!ImGui::BeginMainMenuBar()) return;
    for (const char* menu : {"File", "Edit", "Rays", "Camera", "Layers", "Compare", "Lab", "View"}) {
        const bool open = ImGui::BeginMenu(menu);
        ui.mark(fmt::format("menu {}", menu));
        if (!open) continue;
        for (const Action& action : actions()) {
            if (action.menu != menu) continue;
            const bool possible = (action.command != "undo" || viewer_.canUndo()) &&
                                  (action.command != "redo" || viewer_.canRedo());
            if (ImGui::MenuItem(std::string(action.label).c_str(), std::string(action.chord).c_str(), false,
                                possible))
                execute(Command::parse(action.command));
            ui.mark(fmt::format("menu {}", action.command));
            if (action.command == "reload") recentMenu(ui);
        }
        ImGui::EndMenu();
    }
    ImGui::EndMainMenuBar();
}

void Gui::recentMenu(const Widgets& ui) {
    if (!ImGui::BeginMenu("Recent scenes", !preferences_.recentScenes.empty())) return;
    const std::vector<std::string> recent = preferences_.recentScenes;
    for (const std::string& scene : recent) {
        if (ImGui::MenuItem(scene.c_str())) execute({"open", {{"scene", scene}}});
        ui.mark("recent " + scene);
    }
    ImGui::EndMenu();
}

void Gui::show(Dialog dialog) {
    dialog_ = dialog;
    const auto folder = viewer_.hasScene() ? viewer_.opened().path.parent_path() : std::filesystem::path();
    if (dialog == Dialog::Open) files_.begin(FileDialog::Purpose::Open, folder, {".gltf", ".glb", ".png"});
    if (dialog == Dialog::NameBug)
        files_.begin(FileDialog::Purpose::Open, folder, {".png", ".jpg", ".ppm", ".exr", ".hdr", ".pfm"});
    if (dialog == Dialog::Save)
        files_.begin(FileDialog::Purpose::Save, folder, {".gltf", ".glb"}, "scene.gltf");
}

void Gui::dialog(const Widgets& ui) {
    if (dialog_ == Dialog::None) return;
    constexpr std::array kTitles = {"",
                                    "Open a scene",
                                    "Save the scene",
                                    "Keys and commands",
                                    "Import report",
                                    "A picture of this scene that came out wrong"};
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    const ImVec2 size{std::min(window.WorkSize.x * 0.94F, ImGui::GetFontSize() * 52),
                      window.WorkSize.y * 0.86F};
    ImGui::SetNextWindowPos(
        {window.WorkPos.x + window.WorkSize.x / 2, window.WorkPos.y + window.WorkSize.y / 2},
        ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize(size, ImGuiCond_Always);
    bool open = true;
    if (ImGui::Begin(kTitles[static_cast<std::size_t>(dialog_)], &open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoSavedSettings)) {
        if (dialog_ == Dialog::Help) helpPage(ui);
        if (dialog_ == Dialog::Report) importReport(ui);
        if (dialog_ == Dialog::Open || dialog_ == Dialog::Save || dialog_ == Dialog::NameBug) fileDialog(ui);
    }
    ImGui::End();
    if (!open) dialog_ = Dialog::None;
}

void Gui::fileDialog(const Widgets& ui) {
    const auto file = files_.draw(ui);
    if (!file) return;
    const Dialog dialog = std::exchange(dialog_, Dialog::None);
    if (dialog == Dialog::Open) execute({"open", {{"scene", file->string()}}});
    if (dialog == Dialog::Save) execute({"save", {{"file", file->string()}}});
    if (dialog == Dialog::NameBug) execute({"name-bug", {{"file", file->string()}}});
}

void Gui::writeRays(const Widgets& ui) {
    const RaysFile wanted = *std::exchange(raysFile_, std::nullopt);
    try {
        rayPane_.save(ui, picture_, wanted.file, wanted.size);
        viewer_.report(Notice::Kind::Done, fmt::format("rays in space saved as {}", wanted.file.string()));
    } catch (const std::exception& error) {
        viewer_.report(Notice::Kind::Error, error.what());
    }
}

void Gui::afterFrame() {
    if (!windowFile_) return;
    const std::filesystem::path file = *windowFile_;
    windowFile_.reset();
    try {
        const PictureState state = viewer_.hasScene() ? viewer_.pictureState() : PictureState{};
        writeFileAtomically(file, encodeDisplayed(platform_.screenshot(), ImageFormat::Png,
                                                  toMetadata(state, file.parent_path())));
        viewer_.report(Notice::Kind::Done, fmt::format("window saved as {}", file.string()));
    } catch (const std::exception& error) {
        viewer_.report(Notice::Kind::Error, error.what());
    }
}

}
