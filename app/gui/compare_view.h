#pragma once
// Two pictures with a line between them that can be dragged, or their difference.

#include <string>
#include <vector>

#include "app/gui/film_texture.h"
#include "app/gui/legend.h"

namespace eyeray {

/// The settings in which the two sides differ, as each side has them, one a line: "max-depth=1" and
/// "max-depth=5".
struct SideNames {
    std::string other, own;
};
SideNames sideNames(const Document&);

/// What both sides have in common and what not, so far: "12.3 % of pixels differ after 4 samples".
std::string changeText(const PictureChange&);

/// How wrong the other side is, and what it cost, a line each: "1 234 pixels wrong (1.3 %)".
std::vector<std::string> wrongLines(const PictureChange&);

class CompareView {
public:
    explicit CompareView(const Gl& gl) : other_(gl), difference_(gl), marks_(gl) {}

    /// Takes over what the viewer has traced of the other side.
    void refresh(const Viewer&);

    /// Lets the mouse drag the line. To be called before the picture's own button, over which it lies.
    static void handle(const Widgets&, ImVec2 corner, ImVec2 size);

    /// Draws the other side over the left of the picture, or all over it; or the difference. `raster` is what
    /// OpenGL draws.
    void draw(const Widgets&, const GlTexture& raster, ImVec2 corner, ImVec2 size, bool wholly) const;

    void legend(const Widgets&, const LegendPlace&) const;

private:
    void splitLine(const Widgets&, ImVec2 corner, ImVec2 size) const;
    static void labLegend(const Widgets&);

    FilmTexture other_;
    GlTexture difference_, marks_;
    std::shared_ptr<const PictureChange> marked_; // that marks_ shows
    std::shared_ptr<const PictureChange> change_; // that difference_ shows
    float differenceGain_ = 0;
    DisplaySettings differenceDisplay_;
};

}
