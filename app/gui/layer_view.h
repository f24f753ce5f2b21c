#pragma once
// A layer in place of the picture, with its legend.

#include <memory>
#include <vector>

#include "app/gl/texture.h"
#include "app/gui/legend.h"
#include "core/study/layer_picture.h"

namespace eyeray {

class LayerView {
public:
    explicit LayerView(const Gl& gl) : texture_(gl) {}

    /// Takes over what the viewer has traced of the layer it shows.
    void refresh(const Viewer&);

    /// False as long as there is nothing of it.
    bool showing() const { return showing_; }
    const GlTexture& texture() const { return texture_; }

    /// What it has at a place of the picture, both as shares of the picture's sides: "visits: 57 nodes".
    std::string textAt(double across, double down) const;

    /// Name and meaning, and the colour bar with its numbers or the objects with their colours.
    void legend(const Widgets&, const LegendPlace&) const;

private:
    void countObjects();
    void objects(const Scene&, float height) const;
    void colorBar(float width) const;

    GlTexture texture_;
    /// What the rest was made of.
    struct Shown {
        std::shared_ptr<const LayerFilm> film;
        std::uint64_t counted = 0; // film whose samples are counted, where that is the layer
        int samples = 0;
        DisplaySettings display;
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    Shown shown_;
    bool showing_ = false;
    LayerImage image_;
    LayerRange range_;
    std::vector<int> objects_; // of an id layer, largest in the picture first
};

}
