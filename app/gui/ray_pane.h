#pragma once
// The pane that shows the scene with the picked pixel's rays from outside.

#include <filesystem>
#include <optional>

#include "app/gui/index_choice.h"
#include "app/gui/picture_view.h"
#include "app/gui/traced_pixels.h"
#include "app/gui/widgets.h"
#include "app/rayview/ray_view.h"

namespace eyeray {

class RayPane {
public:
    explicit RayPane(const Gl& gl) : gl_(gl), view_(gl) {}

    /// Begins with a view of the whole when another scene is open; to be called once a frame.
    void noticeScene(const Viewer&);

    /// Fills what is left of the current ImGui window.
    void draw(const Widgets&, const PictureView&);

    /// Writes what the pane shows, whether it is seen or not, in its size or in another: a PNG, or an SVG
    /// with the rays as vectors, by the ending of the name. Throws InputError, Failure.
    void save(const Widgets&, const PictureView&, const std::filesystem::path&, std::optional<PictureSize>);

    /// Carries out `rayview …`; throws InputError for an argument it does not know.
    void execute(const Command&);

    const RayView& view() const { return view_; }

private:
    Sketch compose(const Widgets&, const PictureView&, PictureSize, const RayStyle&);
    void toolbar(const Widgets&);
    void shownRaysChoice(const Widgets&) const;
    RayViewContent content(const Widgets&, const PictureView&);
    void mouse(const Widgets&, ImVec2 corner);
    void rayTooltip(const Widgets&, int arrow) const;
    void caption(const Widgets&, Sketch&, const RayStyle&, PictureSize);

    const Gl& gl_;
    RayView view_;
    ShownRays show_ = ShownRays::Pixel;
    int step_ = 0; // pixels; 0: chosen so that the rays stay apart
    bool labels_ = true;
    std::string scene_; // whose view it is

    IndexChoice index_;
    TracedPixels many_;
    SampleRecord played_;        // the rays so far, while a sample is played
    PictureSize size_{960, 720}; // as last seen
    bool dragging_ = false;
};

}
