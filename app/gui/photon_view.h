#pragma once
// The picture that photons make which have entered the eye.

#include "app/gl/texture.h"
#include "app/gui/legend.h"

namespace eyeray {

class PhotonView {
public:
    explicit PhotonView(const Gl& gl) : texture_(gl) {}

    /// Takes over what the viewer has of it.
    void refresh(const Viewer&);

    /// True if there is something to show.
    bool showing() const { return picture_ != nullptr; }
    const GlTexture& texture() const { return texture_; } // one texel to a block
    /// Changes whenever what is shown does.
    std::uint64_t version() const { return version_; }

    /// What it shows, in words.
    void legend(const Widgets&, const LegendPlace&) const;

private:
    GlTexture texture_;
    std::shared_ptr<const PhotonPicture> picture_;
    DisplaySettings display_;
    std::uint64_t version_ = 0;
};

}
