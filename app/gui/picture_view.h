#pragma once
// The picture in the window, and what the mouse does over it.

#include <optional>

#include "app/gl/texture.h"
#include "app/gui/widgets.h"
#include "app/rayview/rasteriser.h"
#include "core/image/pixels.h"

namespace eyeray {

class PictureView {
public:
    explicit PictureView(const Gl& gl) : gl_(gl), texture_(gl) {}

    /// Draws the picture, as large as it fits with its aspect, in what is left of the current ImGui window.
    void draw(const Widgets&);

    /// Shows what OpenGL draws of the scene instead of what is traced.
    void setRasterised(bool on);
    bool rasterised() const { return rasterised_; }

    /// What the view shows, as displayed.
    const ByteImage& shown() const { return shown_; }
    const GlTexture& texture() const { return texture_; }
    /// Changes whenever what is shown does.
    std::uint64_t version() const { return version_; }

private:
    /// What the rasterised picture was drawn for.
    struct RasterisedFor {
        std::shared_ptr<const World> world;
        Camera camera;
        PictureSize size;
        DisplaySettings display;
        friend bool operator==(const RasterisedFor&, const RasterisedFor&) = default;
    };

    void refresh(const Widgets&);
    void rasterise(const Widgets&);
    void rasterisedNote(const Widgets&, ImVec2 corner) const;
    void show(const std::vector<Tile>&, const DisplaySettings&);
    void mouse(const Widgets&, ImVec2 corner);
    void drag(const Widgets&, int button, ImVec2 delta);
    void pick(const Widgets&, ImVec2 position, ImVec2 corner);
    void pickedMark(const Widgets&, ImVec2 corner) const;

    const Gl& gl_;
    std::optional<Rasteriser> rasteriser_; // from its first use on
    std::optional<RasterisedFor> rasterisedFor_;
    bool rasterised_ = false;
    GlTexture texture_;
    Picture picture_;
    ByteImage shown_;
    std::uint64_t version_ = 0;
    std::optional<DisplaySettings> display_; // that `shown_` was made with
    int drags_ = 0;                          // counts them, so that each is one step of undo
    bool dragging_ = false;
};

}
