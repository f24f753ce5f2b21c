#pragma once
// The live chart: time against error of each picture while it refines.

#include "app/gl/texture.h"
#include "app/gui/widgets.h"

namespace eyeray {

class ChartView {
public:
    explicit ChartView(const Gl& gl) : picture_(gl, Magnify::Smooth) {}

    /// The chart over what is left of the current window. A click on a point returns to its settings.
    void plot(const Widgets&);
    /// Its switches and the list of its curves.
    void list(const Widgets&) const;

private:
    void tell(const Widgets&, const RecordedCurve&, const RecordedPoint&);

    GlTexture picture_; // of the point under the pointer
    ByteImage shown_;
};

}
