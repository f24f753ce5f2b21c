#include "app/gui/actions.h"

#include <array>

namespace eyeray {
namespace {

constexpr std::array kActions = {
    Action{"File", "Open a scene…", "Ctrl+O", "dialog show=open"},
    Action{"File", "Load the scene again", "F5", "reload"},
    Action{"File", "Save the scene…", "Ctrl+S", "dialog show=save"},
    Action{"File", "Picture to a file", "F12", "screenshot"},
    Action{"File", "Window to a file", "Shift+F12", "window-screenshot"},
    Action{"File", "Rays in space to a file", "Ctrl+F12", "rayview-screenshot"},
    Action{"File", "Import report", "F2", "dialog show=report"},
    Action{"File", "Quit", "Ctrl+Q", "quit"},

    Action{"Edit", "Undo", "Ctrl+Z", "undo"},
    Action{"Edit", "Redo", "Ctrl+Shift+Z", "redo"},
    Action{"Edit", "Reset to the scene's own state", "Ctrl+R", "reset"},
    Action{"Edit", "Select nothing", "Escape", "deselect"},

    Action{"Rays", "Step 1: Phong alone", "1", "step n=1"},
    Action{"Rays", "Step 2: and shadow rays", "2", "step n=2"},
    Action{"Rays", "Step 3: and reflection", "3", "step n=3"},
    Action{"Rays", "Step 4: and transmission", "4", "step n=4"},
    Action{"Rays", "Shadow rays on or off", "S", "toggle key=shadows"},
    Action{"Rays", "Reflection rays on or off", "R", "toggle key=reflections"},
    Action{"Rays", "Refraction rays on or off", "T", "toggle key=refractions"},
    Action{"Rays", "One level deeper", "PageUp", "adjust key=max-depth by=1"},
    Action{"Rays", "One level less deep", "PageDown", "adjust key=max-depth by=-1"},
    Action{"Rays", "Method: local", "F6", "set method=local"},
    Action{"Rays", "Method: cast", "F7", "set method=cast"},
    Action{"Rays", "Method: Whitted", "F8", "set method=whitted"},
    Action{"Rays", "Method: distributed", "F9", "set method=distributed"},
    Action{"Rays", "Method: path", "F10", "set method=path"},
    Action{"Rays", "Rasterised by OpenGL, or traced", "G", "rasterised"},
    Action{"Rays", "Pause or go on", "Space", "pause"},

    Action{"Camera", "Frame the scene", "Home", "frame"},
    Action{"Camera", "Frame the selected object", "Shift+Home", "frame-selected"},
    Action{"Camera", "Next camera of the scene", "C", "next-camera"},
    Action{"Camera", "Wider field of view", "F", "adjust key=fov by=5"},
    Action{"Camera", "Narrower field of view", "Shift+F", "adjust key=fov by=-5"},
    Action{"Camera", "Fly: W A S D move, Q E down and up", "V", "fly"},

    Action{"Layers", "Next layer", "N", "layer by=1"},
    Action{"Layers", "Layer before", "Shift+N", "layer by=-1"},
    Action{"Layers", "The picture itself", "Shift+O", "layer name=color"},
    Action{"Layers", "Normals", "", "layer name=normal"},
    Action{"Layers", "Depth", "", "layer name=depth"},
    Action{"Layers", "Albedo", "", "layer name=albedo"},
    Action{"Layers", "Objects", "", "layer name=id"},
    Action{"Layers", "Rays per sample", "", "layer name=rays"},
    Action{"Layers", "Recursion depth", "", "layer name=recursion"},
    Action{"Layers", "Nodes visited", "", "layer name=visits"},
    Action{"Layers", "Intersection tests", "", "layer name=tests"},
    Action{"Layers", "Cost in time", "", "layer name=cost"},
    Action{"Layers", "Estimated error", "", "layer name=error"},
    Action{"Layers", "What eye rays bring", "", "layer name=eye"},
    Action{"Layers", "What shadow rays bring", "", "layer name=shadow"},
    Action{"Layers", "What reflection rays bring", "", "layer name=reflection"},
    Action{"Layers", "What refraction rays bring", "", "layer name=refraction"},

    Action{"Compare", "Split view on or off", "K", "compare"},
    Action{"Compare", "Difference, or what the last switch changed", "D", "difference"},
    Action{"Compare", "With depth 1", "", "compare with=\"max-depth=1\""},
    Action{"Compare", "With no shadow rays", "", "compare with=\"shadows=off\""},
    Action{"Compare", "With no reflection rays", "", "compare with=\"reflections=off\""},
    Action{"Compare", "With no refraction rays", "", "compare with=\"refractions=off\""},
    Action{"Compare", "With local illumination", "", "compare with=\"method=local\""},
    Action{"Compare", "With what OpenGL rasterises", "", "compare with=rasterised"},
    Action{"Compare", "With constant weights at glass", "", "compare with=\"fresnel=constant\""},

    Action{"Lab", "A sphere far away", "", "open scene=lab-sphere"},
    Action{"Lab", "One epsilon for all", "", "open scene=lab-epsilon"},
    Action{"Lab", "The same epsilon at another scale", "", "open scene=lab-scale"},
    Action{"Lab", "Sparks through a closed mesh", "", "open scene=lab-leaks"},
    Action{"Lab", "Triangles that vanish", "", "open scene=lab-holes"},
    Action{"Lab", "Two surfaces in one place", "", "open scene=lab-coplanar"},
    Action{"Lab", "Far from the origin", "", "open scene=lab-far"},
    Action{"Lab", "Normals of a squashed ball", "", "open scene=lab-squash"},
    Action{"Lab", "Out of glass", "", "open scene=lab-glass"},
    Action{"Lab", "The terminator", "", "open scene=lab-terminator"},
    Action{"Lab", "Where recursion ends", "", "open scene=lab-tunnel"},
    Action{"Lab", "A cutoff for faint rays", "", "open scene=lab-cutoff"},
    Action{"Lab", "Roulette without its weights", "", "open scene=lab-roulette"},
    Action{"Lab", "Clamped fireflies", "", "open scene=lab-fireflies"},
    Action{"Lab", "Random numbers by the pixel's number", "", "open scene=lab-seeds"},
    Action{"Lab", "Aliasing", "", "open scene=lab-aliasing"},
    Action{"Lab", "A checker in three dimensions", "", "open scene=lab-checker"},
    Action{"Lab", "Name that bug: a picture that came out wrong…", "", "dialog show=name-bug"},
    Action{"Lab", "Mark wrong pixels", "X", "mark-wrong"},
    Action{"Lab", "Slider on", "]", "lab by=1"},
    Action{"Lab", "Slider back", "[", "lab by=-1"},

    Action{"View", "Explain the picked pixel: rays, tree, sum", "E", "explain"},
    Action{"View", "Play how the pixel is traced", "Y", "play"},
    Action{"View", "Play: the next ray", ".", "play to=next"},
    Action{"View", "Play: one ray back", ",", "play to=back"},
    Action{"View", "Play: the next hit", "Shift+.", "play to=hit"},
    Action{"View", "Play a coarse picture, pixel by pixel", "Shift+Y", "play-grid"},
    Action{"View", "What is under the pointer", "H", "hover"},
    Action{"View", "From the light: photons from the lamps", "Shift+L", "from-light"},
    Action{"View", "Chart time against error, live", "M", "chart"},
    Action{"View", "Boxes of the index, level by level", "", "rayview boxes=level"},
    Action{"View", "Boxes that the ray is tested against", "", "rayview boxes=ray"},
    Action{"View", "No boxes", "", "rayview boxes=none"},
    Action{"View", "Brighter", "B", "adjust key=exposure by=0.5"},
    Action{"View", "Darker", "Shift+B", "adjust key=exposure by=-0.5"},
    Action{"View", "Presenter size", "P", "presenter"},
    Action{"View", "Dark or light theme", "L", "theme"},
    Action{"View", "Hide or show the panels", "Tab", "panels"},
    Action{"View", "Full screen", "F11", "fullscreen"},
    Action{"View", "Keys and commands", "F1", "dialog show=help"},

    Action{"", "Picked pixel to the left", "Left", "move-pixel x=-1 y=0"},
    Action{"", "Picked pixel to the right", "Right", "move-pixel x=1 y=0"},
    Action{"", "Picked pixel up", "Up", "move-pixel x=0 y=-1"},
    Action{"", "Picked pixel down", "Down", "move-pixel x=0 y=1"},
};

constexpr std::array kGestures = {
    Gesture{"Over the picture", "a few lines tell of the pixel under the pointer; H switches them off"},
    Gesture{"Left click", "picks the pixel and selects its object"},
    Gesture{"Left drag", "orbits about the target"},
    Gesture{"Middle drag", "moves the camera sideways"},
    Gesture{"Wheel", "moves the camera nearer or farther"},
    Gesture{"Shift + left drag", "moves the selected object"},
    Gesture{"Right drag", "looks around from where the eye is"},
    Gesture{"Drag the line", "moves the border between two compared pictures"},
    Gesture{"Hold O", "shows the picture in place of a layer, or the other side of a comparison alone"},
    Gesture{"Over the rays in space", "left drag orbits, middle drag moves, the wheel comes nearer; a click "
                                      "on a ray selects it"},
    Gesture{"Drop a file", "opens a scene, or a picture that Eyeray made"},
};

}

std::span<const Action> actions() { return kActions; }
std::span<const Gesture> gestures() { return kGestures; }

}
