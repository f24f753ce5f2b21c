#include "app/rayview/ray_view.h"

#include <algorithm>
#include <utility>

#include "app/rayview/pen.h"

namespace eyeray {
namespace {

constexpr int kSamplesPerPixel = 4;     // of OpenGL's own smoothing: in software three times the time of one
constexpr double kNearest = 0.01;       // of the distance to what is looked at
constexpr double kFarthest = 12;        // radii of the scene behind its middle
constexpr float kReach = 2.5F;          // of endless rays, in radii of the scene
constexpr float kTolerance = 0.003F;    // of the outside distance: see DepthView
constexpr double kGridApart = 7;        // pixels at least
constexpr std::size_t kFewPhotons = 24; // steps of photons that are drawn as wide as a single sample's rays
constexpr float kThinMany = 0.55F;      // width of rays where several samples are shown
constexpr float kPale = 0.6F;           // of the rays of the pixel under the pointer
constexpr std::size_t kMostHovered = 200;

Projection projectionFor(const World& world, const Camera& outside, int width, int height) {
    const double distance = outside.distance();
    const double toMiddle = glm::length(outside.eye - world.origin);
    return {
        outside, world.origin,        width,
        height,  kNearest * distance, toMiddle + distance + kFarthest * static_cast<double>(world.radius)};
}

}

RayView::RayView(const Gl& gl) : gl_(gl), meshes_(gl), painter_(gl), quad_(gl) {}

void RayView::draw(const RayViewContent& content, int width, int height, const RayStyle& style,
                   const Backdrop& backdrop) {
    outside_.update(content.camera, static_cast<double>(width) / height);
    const ImagePlane plane =
        imagePlaneOf(content.camera, content.world->origin, content.aspect, content.camera.distance());
    const bool redrawn = drawScene(content, width, height, backdrop);
    if (redrawn || drawnPicture_ != content.pictureVersion || drawnCamera_ != content.camera) {
        drawPlane(content, plane);
        depth_ = shown_->readDepth();
        drawnPicture_ = content.pictureVersion;
        drawnCamera_ = content.camera;
    }
    gl_.bindFramebuffer(GL_FRAMEBUFFER, 0);
    drawSketch(content, plane, style);
}

/// True if it had to.
bool RayView::drawScene(const RayViewContent& content, int width, int height, const Backdrop& backdrop) {
    const bool sized = scene_ && scene_->width() == width && scene_->height() == height;
    const int samples = content.hurried ? 1 : kSamplesPerPixel;
    if (sized && samples <= samplesPerPixel_ && drawnWorld_ == content.world &&
        drawnOutside_ == outside_.camera() && drawnBackdrop_ == backdrop)
        return false;
    if (!sized) shown_.emplace(gl_, width, height, Framebuffer::Depth::With);
    if (!sized || samples != samplesPerPixel_)
        scene_.emplace(gl_, width, height, std::vector<GLenum>{GL_RGBA8}, samples);
    samplesPerPixel_ = samples;
    meshes_.update(content.world);
    projection_.emplace(projectionFor(*content.world, outside_.camera(), width, height));
    scene_->bind();
    painter_.draw(meshes_, *projection_, backdrop);
    drawnWorld_ = content.world;
    drawnOutside_ = outside_.camera();
    drawnBackdrop_ = backdrop;
    return true;
}

void RayView::drawPlane(const RayViewContent& content, const ImagePlane& plane) {
    scene_->copyTo(*shown_);
    if (content.picture == nullptr || content.picture->width() == 0) return;
    shown_->bind();
    const auto length = [&](std::size_t a, std::size_t b) {
        const auto line = projection_->line(plane.corners[a], plane.corners[b]);
        return line ? glm::length(line->to.at - line->from.at) : 0.0F;
    };
    const int step = std::min(gridStep(content.pictureWidth, length(0, 1), kGridApart),
                              gridStep(content.pictureHeight, length(0, 3), kGridApart));
    quad_.draw(*content.picture, plane, *projection_,
               DVec2(content.pictureWidth, content.pictureHeight) / static_cast<double>(step));
}

void RayView::drawHovered(const RayViewContent& content, const DepthView& view, const ImagePlane& plane,
                          const RayStyle& style) {
    RayStyle pale = style;
    for (Ink& ink : pale.kinds) ink = faded(ink, kPale);
    for (Ink* const ink : {&pale.blocked, &pale.unlit, &pale.highlight}) *ink = faded(*ink, kPale);
    Sketch hovered;
    drawPixel(hovered, view, plane, content.hoveredPixel, content.pictureWidth, content.pictureHeight, pale);
    const auto arrows = arrowsOf(*content.hovered, *content.world, 0, kReach * content.world->radius);
    drawArrows(hovered, view, weightiest(arrows, kMostHovered, -1), pale, -1, kThinMany);
    for (SketchPath& path : hovered.paths) {
        path.tag = -1; // clicks do not select them
        sketch_.paths.push_back(std::move(path));
    }
}

void RayView::drawSketch(const RayViewContent& content, const ImagePlane& plane, const RayStyle& style) {
    const auto tolerance = static_cast<float>(kTolerance * outside_.camera().distance());
    const DepthView view{*projection_, depth_, tolerance};
    arrows_.clear();
    for (std::size_t i = 0; i < content.samples.size(); ++i) {
        const auto added = arrowsOf(*content.samples[i], *content.world, static_cast<int>(i),
                                    kReach * content.world->radius);
        arrows_.insert(arrows_.end(), added.begin(), added.end());
    }
    arrows_.insert(arrows_.end(), content.photons.begin(), content.photons.end());
    leftOut_ = arrows_.size();
    arrows_ = weightiest(std::move(arrows_), kMostArrows, content.selectedRay);
    leftOut_ -= arrows_.size();
    const auto selected = std::find_if(arrows_.begin(), arrows_.end(), [&](const Arrow& arrow) {
        return content.pixel && arrow.sample == 0 && arrow.ray == content.selectedRay;
    });
    sketch_ = {};
    drawLamps(sketch_, view, *content.world, style, content.labels);
    drawEye(sketch_, view, plane, style, content.labels);
    if (content.lens) drawLens(sketch_, view, *content.lens, style);
    if (content.pixel)
        drawPixel(sketch_, view, plane, *content.pixel, content.pictureWidth, content.pictureHeight, style);
    if (content.hovered != nullptr) drawHovered(content, view, plane, style);
    if (content.index != nullptr) drawIndex(sketch_, view, *content.index, style);
    const bool many = content.samples.size() > 1 || content.photons.size() > kFewPhotons;
    drawArrows(sketch_, view, arrows_, style,
               selected == arrows_.end() ? -1 : static_cast<int>(selected - arrows_.begin()),
               many ? kThinMany : 1.0F);
    if (!content.labels || content.samples.size() != 1) return;
    const auto vectors = vectorsAt(*content.samples.front(), content.selectedRay);
    if (!vectors) return;
    const std::vector<SketchLabel> others = std::exchange(sketch_.labels, {}); // less urgent
    drawVectors(sketch_, *projection_, *vectors, style);
    sketch_.labels.insert(sketch_.labels.end(), others.begin(), others.end());
}

}
