#pragma once
// Flat drawings: what is laid over a picture on the screen and in files.

#include <string>
#include <vector>

#include "core/base/math.h"

namespace eyeray {

/// sRGB-coded, 0 to 1; alpha not premultiplied.
using Ink = Vec4;

/// A closed polygon that is filled, or an open line of some width; pixels from the top left corner.
struct SketchPath {
    std::vector<Vec2> points;
    Ink ink{1};
    float width = 0; // pixels; 0: filled
    int tag = -1;    // what it belongs to
};

struct SketchLabel {
    Vec2 at{0};
    std::string text;
    Ink ink{1};
    Vec2 anchor{0}; // which point of the text stands at `at`: (0, 0) its top left, (1, 1) its bottom right
    float size = 1; // of its letters, in those of the surroundings
};

/// Later paths cover earlier ones; labels cover all paths.
struct Sketch {
    std::vector<SketchPath> paths;
    std::vector<SketchLabel> labels;

    void line(const Vec2& from, const Vec2& to, const Ink& ink, float width, int tag = -1) {
        paths.push_back({{from, to}, ink, width, tag});
    }
    void fill(std::vector<Vec2> points, const Ink& ink, int tag = -1) {
        paths.push_back({std::move(points), ink, 0, tag});
    }
};

}
