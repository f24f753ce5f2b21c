#pragma once
// The scene with its rays from outside: a picture drawn by OpenGL and a flat drawing to lay over it.

#include <optional>

#include "app/rayview/index_sketch.h"
#include "app/rayview/outside_painter.h"
#include "app/rayview/outside_view.h"
#include "app/rayview/ray_sketch.h"
#include "core/transport/integrator.h"

namespace eyeray {

/// More arrows at once show nobody anything: the rest, of the least weight, is left out.
inline constexpr std::size_t kMostArrows = 1000;

/// What there is to see.
struct RayViewContent {
    std::shared_ptr<const World> world;
    Camera camera;                            // of the picture
    const GlTexture* picture = nullptr;       // what it shows so far
    std::uint64_t pictureVersion = 0;         // changes with the picture
    int pictureWidth = 0, pictureHeight = 0;  // pixels that its grid shows
    double aspect = 1;                        // its width / height
    std::optional<DVec2> pixel;               // picked
    std::vector<const SampleRecord*> samples; // those whose rays are shown, the picked one first
    int selectedRay = 0;                      // of the first sample
    const IndexPicture* index = nullptr;      // boxes to be drawn too
    const SampleRecord* hovered = nullptr;    // a sample whose rays are shown pale
    DVec2 hoveredPixel{0};
    std::vector<Arrow> photons; // their ways
    std::optional<Lens> lens;   // that they are to find
    bool hurried = false;       // something is being dragged: rather soon than smooth
    bool labels = true;         // names, coordinates, vectors and angles
};

/// Used by the thread of its OpenGL.
class RayView {
public:
    explicit RayView(const Gl&);

    /// Draws what has changed, width × height pixels.
    void draw(const RayViewContent&, int width, int height, const RayStyle&, const Backdrop&);

    OutsideView& outside() { return outside_; }
    const OutsideView& outside() const { return outside_; }

    // what has been drawn last
    const GlTexture& picture() const { return shown_->color(); }
    ByteImage readPicture() const { return shown_->read(); }
    const Sketch& sketch() const { return sketch_; }
    const std::vector<Arrow>& arrows() const { return arrows_; }
    std::size_t raysLeftOut() const { return leftOut_; } // beyond kMostArrows
    const std::optional<Projection>& projection() const { return projection_; }
    const SceneMeshes& meshes() const { return meshes_; }

private:
    bool drawScene(const RayViewContent&, int width, int height, const Backdrop&);
    void drawPlane(const RayViewContent&, const ImagePlane&);
    void drawHovered(const RayViewContent&, const DepthView&, const ImagePlane&, const RayStyle&);
    void drawSketch(const RayViewContent&, const ImagePlane&, const RayStyle&);

    const Gl& gl_;
    SceneMeshes meshes_;
    OutsidePainter painter_;
    PictureQuad quad_;
    OutsideView outside_;

    std::optional<RenderTarget> scene_; // without plane
    int samplesPerPixel_ = 0;           // of its own
    std::optional<Framebuffer> shown_;
    Pixels<float> depth_;
    std::optional<Projection> projection_;

    // what the scene and the picture were drawn for
    std::shared_ptr<const World> drawnWorld_;
    Camera drawnOutside_, drawnCamera_;
    Backdrop drawnBackdrop_;
    std::uint64_t drawnPicture_ = 0;

    std::vector<Arrow> arrows_;
    std::size_t leftOut_ = 0;
    Sketch sketch_;
};

}
