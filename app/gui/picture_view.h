#pragma once
// The picture in the window, and what the mouse does over it.

#include "app/gui/compare_view.h"
#include "app/gui/film_texture.h"
#include "app/gui/grid_view.h"
#include "app/gui/hover_view.h"
#include "app/gui/layer_view.h"
#include "app/gui/photon_view.h"
#include "app/gui/raster_view.h"
#include "app/gui/widgets.h"

namespace eyeray {

class PictureView {
public:
    explicit PictureView(const Gl& gl)
        : film_(gl), raster_(gl), layer_(gl), compare_(gl), grid_(gl), photons_(gl) {}

    /// Draws the picture, as large as it fits with its aspect, in what is left of the current ImGui window:
    /// or a layer of it, or it and the other side of a comparison. With `other`, what these stand in place
    /// of: the picture itself, or the other side alone.
    void draw(const Widgets&, bool other);

    /// Shows what OpenGL draws of the scene instead of what is traced.
    void setRasterised(bool on);
    bool rasterised() const { return rasterised_; }

    /// Tells of the pixel under the pointer.
    void setHover(bool on) { hovers_ = on; }
    const HoverView& hover() const { return hover_; }

    /// The picture, as displayed.
    const ByteImage& shown() const { return rasterised_ ? raster_.shown() : film_.shown(); }
    /// The same on the graphics card; or the coarse picture while that is played, or that of the photons.
    const GlTexture& texture() const;
    /// Changes whenever the texture does.
    std::uint64_t version() const {
        return film_.version() + raster_.version() + grid_.version() + photons_.version() + switches_;
    }

private:
    void refresh(const Widgets&);
    void photonImage(const Widgets&, ImVec2 corner, ImVec2 size) const;
    void image(const Widgets&, ImVec2 corner, ImVec2 size, bool other) const;
    void mouse(const Widgets&, ImVec2 corner);
    void drag(const Widgets&, int button, ImVec2 delta);
    void tellHovered(const Widgets&, ImVec2 corner, ImVec2 middle);
    std::optional<PixelPosition> pixelAt(ImVec2 position, ImVec2 corner) const;
    void pick(const Widgets&, ImVec2 position, ImVec2 corner);
    void pickedMark(const Widgets&, ImVec2 corner) const;

    FilmTexture film_;
    RasterView raster_;
    LayerView layer_;
    CompareView compare_;
    GridView grid_;
    PhotonView photons_;
    HoverView hover_;
    bool rasterised_ = false, playsGrid_ = false, hovers_ = true;
    std::uint64_t switches_ = 0; // between traced, rasterised and coarse
    int drags_ = 0;              // counts them, so that each is one step of undo
    bool dragging_ = false;
};

}
