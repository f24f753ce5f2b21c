// The failure lab as a document: a scene by rule, its slider, its naive side.

#include <algorithm>
#include <array>

#include "app/document/document_commands.h"
#include "core/base/errors.h"

namespace eyeray {
namespace {

/// Takes over what another value of the slider changes; what a person has changed meanwhile stays.
void slide(Document& document, double value) {
    const Document before = labDocument(*document.lab, document.labValue);
    const Document after = labDocument(*document.lab, value);
    if (document.camera == before.camera) document.camera = after.camera;
    if (document.comparison.with == before.comparison.with) document.comparison.with = after.comparison.with;
    if (document.render.stop == before.render.stop) document.render.stop = after.render.stop;
    document.scene = after.scene;
    document.labValue = after.labValue;
}

void lab(Document& document, const Command& command) {
    command.allowOnly({"value", "by"});
    if (document.lab == nullptr)
        throw InputError(command.text(), "the scene is none of the failure lab",
                         "open one first, such as: open scene=lab-sphere");
    const LabDemo& demo = *document.lab;
    if (const auto by = command.integer("by", -100, 100)) {
        slide(document, labStep(demo, document.labValue, *by));
    } else {
        command.required("value");
        slide(document, *command.number("value", demo.slider.lowest, demo.slider.highest));
    }
}

void markWrong(Document& document, const Command& command) {
    command.allowOnly({"on"});
    Comparison& comparison = document.comparison;
    comparison.marks = command.flag("on").value_or(!comparison.marks);
}

constexpr std::array kCommands = {
    DocumentCommand{"lab", "value=V|by=N", "Moves the slider of a demonstration of the failure lab.", lab},
    DocumentCommand{"mark-wrong", "on=on|off",
                    "Marks the pixels of the left side that differ from the right one.", markWrong},
};

}

std::span<const DocumentCommand> labCommands() { return kCommands; }

Document originalOf(const Document& document) {
    const LabDemo* const demo = document.lab;
    return demo != nullptr ? labDocument(*demo, demo->slider.start) : makeDocument(document.scene);
}

Document labDocument(const LabDemo& demo, double value) {
    const double inRange = labValue(demo, value);
    Document document = makeDocument(std::make_shared<const Scene>(labScene(demo, inRange)));
    document.lab = &demo;
    document.labValue = inRange;
    document.comparison.on = document.comparison.marks = true;
    document.comparison.with = demo.naive(inRange);
    return document;
}

}
