#include "app/viewer/viewer_commands.h"

#include <fmt/format.h>

#include <array>

#include "app/document/user_folders.h"
#include "app/viewer/chart_commands.h"
#include "app/viewer/study_commands.h"
#include "app/viewer/viewer.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

namespace fs = std::filesystem;

void needScene(const Viewer& viewer, const Command& command) {
    if (!viewer.hasScene()) throw InputError(command.text(), "no scene is open", "open a scene first");
}

void open(Viewer& viewer, const Command& command) {
    command.allowOnly({"scene"});
    viewer.startLoading(command.required("scene"), false);
}

void reload(Viewer& viewer, const Command& command) {
    command.allowOnly({});
    needScene(viewer, command);
    viewer.startLoading(viewer.opened().reference, true);
}

void save(Viewer& viewer, const Command& command) {
    command.allowOnly({"file"});
    needScene(viewer, command);
    const fs::path file = command.required("file");
    exportGltf(viewer.sceneToSave(), file);
    viewer.report(Notice::Kind::Done, fmt::format("scene saved as {}", file.string()));
}

/// The picture alone, as it stands: whole passes, or the coarse picture before there are any.
void savePicture(Viewer& viewer, const fs::path& file) {
    ColorImage image = viewer.session().image();
    if (image.empty()) {
        Picture picture;
        viewer.session().read(picture);
        image = picture.radiance;
    }
    if (image.empty()) throw InputError(file.string(), "there is no picture yet", "wait a moment");
    writePicture(file, image, shownDisplay(viewer.document().render), viewer.pictureState());
}

void saveLayer(Viewer& viewer, const fs::path& file) {
    const std::optional<LayerImage> image = viewer.layerImage();
    if (!image) throw InputError(file.string(), "the layer is not there yet", "wait a moment");
    writeLayer(file, *image, shownDisplay(viewer.document().render), viewer.pictureState());
}

/// What is shown: the picture, or the layer of it.
void screenshot(Viewer& viewer, const Command& command) {
    command.allowOnly({"file"});
    needScene(viewer, command);
    const Layer layer = shownLayer(viewer.document());
    const bool isPicture = layer.quantity == Quantity::Picture;
    std::string stem = fs::path(viewer.opened().reference).stem().string();
    if (!isPicture) stem += "-" + layer.name;
    const fs::path file =
        command.find("file") ? fs::path(*command.find("file")) : freeName(picturesFolder(), stem);
    isPicture ? savePicture(viewer, file) : saveLayer(viewer, file);
    viewer.report(Notice::Kind::Done,
                  fmt::format("{} saved as {}", isPicture ? "picture" : layer.name, file.string()));
}

void difference(Viewer& viewer, const Command& command) {
    command.allowOnly({});
    needScene(viewer, command);
    viewer.toggleDifference();
}

void undo(Viewer& viewer, const Command& command) {
    needScene(viewer, command);
    viewer.undo();
}

void redo(Viewer& viewer, const Command& command) {
    needScene(viewer, command);
    viewer.redo();
}

void reset(Viewer& viewer, const Command& command) {
    needScene(viewer, command);
    viewer.reset();
}

void pause(Viewer& viewer, const Command& command) {
    command.allowOnly({"on"});
    viewer.setPaused(command.flag("on").value_or(!viewer.paused()));
}

void pick(Viewer& viewer, const Command& command) {
    command.allowOnly({"x", "y", "select"});
    needScene(viewer, command);
    if (!command.find("x") && !command.find("y")) return viewer.pick(std::nullopt, false);
    command.required("x");
    command.required("y");
    viewer.pick(
        PixelPosition{*command.integer("x", 0, kMaxPictureSide), *command.integer("y", 0, kMaxPictureSide)},
        command.flag("select").value_or(true));
}

void sample(Viewer& viewer, const Command& command) {
    command.allowOnly({"n"});
    needScene(viewer, command);
    command.required("n");
    viewer.chooseSample(*command.integer("n", 0, 1000000));
}

void selectRay(Viewer& viewer, const Command& command) {
    command.allowOnly({"index"});
    needScene(viewer, command);
    command.required("index");
    viewer.selectRay(*command.integer("index", 0, 1 << 20));
}

void nameBug(Viewer& viewer, const Command& command) {
    command.allowOnly({"file"});
    needScene(viewer, command);
    viewer.nameBug(command.required("file"));
}

void measureNeeds(Viewer& viewer, const Command& command) {
    command.allowOnly({});
    needScene(viewer, command);
    viewer.measureNeeds();
}

void applyNeeds(Viewer& viewer, const Command& command) {
    command.allowOnly({});
    needScene(viewer, command);
    viewer.applyNeeds();
}

void wait(Viewer& viewer, const Command& command) {
    command.allowOnly({"samples"});
    viewer.finishRendering(command.integer("samples", 1, 1000000).value_or(1000000));
}

constexpr std::array kCommands = {
    ViewerCommand{"open", "scene=NAME|FILE", "Opens a built-in scene, a glTF file or a picture's scene.",
                  open},
    ViewerCommand{"reload", "", "Loads the scene file again and keeps the view.", reload},
    ViewerCommand{"save", "file=FILE.gltf|.glb", "Saves the edited scene.", save},
    ViewerCommand{"screenshot", "file=FILE",
                  "Saves the picture or the layer shown; without a name into the Pictures folder.",
                  screenshot},
    ViewerCommand{"undo", "", "Takes back the last change.", undo},
    ViewerCommand{"redo", "", "Does it again.", redo},
    ViewerCommand{"reset", "", "Returns to the scene's own state.", reset},
    ViewerCommand{"pause", "on=on|off", "Pauses or resumes tracing.", pause},
    ViewerCommand{"difference", "",
                  "Shows what differs between the two sides, or what the last switch of a ray kind changed.",
                  difference},
    ViewerCommand{"pick", "x=X y=Y select=on|off",
                  "Picks a pixel and selects its object; without x and y, none.", pick},
    ViewerCommand{"sample", "n=N", "Shows sample N of the picked pixel; 0 goes through its centre.", sample},
    ViewerCommand{"select-ray", "index=N", "Marks a ray of the picked pixel in all views; 0 is the eye ray.",
                  selectRay},
    ViewerCommand{"tree", "show=diagram|table kind=KIND|untraced on=on|off least-weight=W",
                  "Shows the rays of the picked pixel as a diagram or a table, and which of them.", tree},
    ViewerCommand{"collapse", "ray=N on=on|off", "Folds what hangs on a ray of the tree, or unfolds it.",
                  collapse},
    ViewerCommand{"strike", "term=N on=on|off",
                  "Strikes a term of the pixel's sum out, or back in; without a term, brings all back.",
                  strike},
    ViewerCommand{"strike-picture", "",
                  "Takes what is struck out of the pixel's sum out of the whole picture.", strikePicture},
    ViewerCommand{"sum", "show=nested|flat",
                  "The sum of a physical method like the tree of rays, or as a flat list.", sum},
    ViewerCommand{"notation", "name=a|b|glm", "Whose letters the pixel's sum is written in.", notation},
    ViewerCommand{"curve", "n=N name=TEXT color=0..5 pin=on|off",
                  "Names and colours a curve of the live chart; a pinned one stays.", curve},
    ViewerCommand{"curve-return", "n=N", "Brings back the settings that a curve was recorded with.",
                  curveReturn},
    ViewerCommand{"curve-remove", "n=N", "Takes a curve away.", curveRemove},
    ViewerCommand{"chart-reference", "n=N",
                  "Takes a curve's latest picture as right and measures errors against it; without n, none.",
                  chartReference},
    ViewerCommand{"chart-save", "file=FILE.svg|.csv format=svg|csv",
                  "Saves the live chart; without a name into the Pictures folder.", chartSave},
    ViewerCommand{"name-bug", "file=FILE.png",
                  "Ranks the faults that explain a picture of this scene, and picks its first wrong pixel.",
                  nameBug},
    ViewerCommand{"measure-needs", "", "Measures what the picture needs and what it does not.", measureNeeds},
    ViewerCommand{"apply-needs", "", "Makes the picture with no more than it needs, and checks that.",
                  applyNeeds},
    ViewerCommand{"wait", "samples=N", "Waits for so many samples, or until the picture is finished.", wait},
};

}

std::span<const ViewerCommand> viewerCommands() { return kCommands; }

void executeViewerCommand(Viewer& viewer, const Command& command) {
    for (const ViewerCommand& known : kCommands)
        if (known.name == command.name()) return known.run(viewer, command);
    throw InputError(command.text(), "there is no such command",
                     "see the list of commands on F1 or in the README");
}

}
