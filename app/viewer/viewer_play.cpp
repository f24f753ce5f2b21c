// How the viewer plays: the rays of the picked sample, or the pixels of a coarse picture.

#include "app/viewer/viewer.h"

namespace eyeray {

void Viewer::play(PlayTo to) {
    if (grid_.on()) {
        grid_.go(to, gridTrace());
        return pickGridCell();
    }
    player_.go(picked_->trace, to);
    selectedRay_ = player_.shown(picked_->trace) - 1;
}

void Viewer::runPlay(bool on) {
    if (grid_.on()) {
        grid_.run(on);
        return pickGridCell();
    }
    player_.run(picked_->trace, on);
    selectedRay_ = player_.shown(picked_->trace) - 1;
}

bool Viewer::playing() const { return grid_.on() ? grid_.running() : player_.running(); }

void Viewer::setPlaySpeed(double factor) {
    player_.setSpeed(factor);
    grid_.setSpeed(factor);
}

void Viewer::playGrid(bool on) {
    if (on == grid_.on()) return;
    player_.reset();
    if (!on) return grid_.end();
    grid_.begin(gridOver(width_, height_));
    pickGridCell();
}

GridPlayer::Trace Viewer::gridTrace() const {
    return [this](int x, int y) { return session_->retrace(x, y, sample_); };
}

void Viewer::pickGridCell() {
    const auto cell = grid_.current();
    pickPixel(cell ? std::optional(PixelPosition{grid_.grid().middleX(*cell), grid_.grid().middleY(*cell)})
                   : std::nullopt);
}

bool Viewer::updatePlay() {
    if (grid_.on()) {
        const bool stepped = grid_.update(gridTrace());
        if (stepped) pickGridCell();
        return stepped || grid_.running();
    }
    const bool stepped = picked_ && player_.update(picked_->trace);
    if (stepped) selectedRay_ = player_.shown(picked_->trace) - 1;
    return stepped || player_.running();
}

/// The picture that is shown has become another.
void Viewer::retraceGrid() {
    if (!grid_.on()) return;
    grid_.retrace(gridOver(width_, height_), gridTrace());
    pickGridCell();
}

}
