#pragma once
// What OpenGL draws of the scene by itself, as displayed.

#include <memory>
#include <optional>

#include "app/gui/widgets.h"
#include "app/rayview/rasteriser.h"

namespace eyeray {

class RasterView {
public:
    explicit RasterView(const Gl& gl) : gl_(gl), texture_(gl) {}

    /// Draws anew if scene, camera, size or display have changed.
    void refresh(const Viewer&);

    const std::shared_ptr<const ColorImage>& radiance() const { return radiance_; }
    const ByteImage& shown() const { return shown_; }
    const GlTexture& texture() const { return texture_; }
    /// Changes whenever what is shown does.
    std::uint64_t version() const { return version_; }

    /// Says in the picture that it is none of the tracer's.
    void note(const Widgets&, ImVec2 corner) const;

private:
    /// What the picture was drawn for.
    struct DrawnFor {
        std::shared_ptr<const World> world;
        Camera camera;
        PictureSize size;
        DisplaySettings display;
        friend bool operator==(const DrawnFor&, const DrawnFor&) = default;
    };

    const Gl& gl_;
    std::optional<Rasteriser> rasteriser_; // from its first use on
    std::optional<DrawnFor> drawnFor_;
    GlTexture texture_;
    std::shared_ptr<const ColorImage> radiance_;
    ByteImage shown_;
    std::uint64_t version_ = 0;
};

}
