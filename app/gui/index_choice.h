#pragma once
// Which boxes of the index the rays in space are shown with.

#include <memory>
#include <string>

#include "app/gui/widgets.h"
#include "core/study/index_picture.h"

namespace eyeray {

enum class ShownBoxes : std::uint8_t { None, Level, Ray };
inline constexpr std::array<std::string_view, 3> kShownBoxesNames = {"none", "level", "ray"};
inline constexpr int kMostLevels = 256;

class IndexChoice {
public:
    void show(ShownBoxes shown) { shown_ = shown; }
    void setLevel(int level) { level_ = level; }

    /// A list of what can be shown, and for levels a slider, in the current line where they fit.
    void controls(const Widgets&) const;
    /// Room that they take, in pixels.
    float controlsWidth() const;

    /// Null if no boxes are to be shown. Computed anew when the picture's World, the level or the selected
    /// ray has changed.
    const IndexPicture* picture(const Viewer&);

    /// The numbers of what is shown, in a line; empty for none.
    std::string text() const;

private:
    bool slides() const { return shown_ == ShownBoxes::Level && levels_ > 1; }
    void refresh(const Viewer&);

    /// What picture_ was made for.
    struct Made {
        std::shared_ptr<const World> world;
        ShownBoxes shown = ShownBoxes::None;
        int level = 0;
        bool picked = false;
        RayKind kind = RayKind::Eye;
        Vec3 origin{0}, direction{0};
        float t = 0;
        TraceSettings settings;
        friend bool operator==(const Made&, const Made&) = default;
    };

    ShownBoxes shown_ = ShownBoxes::None;
    int level_ = 0;
    Made made_;
    int levels_ = 0; // of made_.world
    IndexPicture picture_;
    TraversalCounts counts_; // of the ray
};

}
