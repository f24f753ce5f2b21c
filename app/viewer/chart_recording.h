#pragma once
// Time against error of the pictures that a person looks at, while they refine.

#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "core/render/render_session.h"
#include "core/study/plot.h"

namespace eyeray {

struct RecordedPoint {
    int samples = 0;
    double seconds = 0; // of tracing
    double error = 0;   // estimated root mean square of linear light
    ColorImage picture; // radiance of every few pixels, a fair sample of all
};

/// One picture under one setting.
struct RecordedCurve {
    std::string name;
    int color = 0;       // colorOfSeries
    bool pinned = false; // stays until a person takes it away
    Document document;   // to return to
    std::vector<RecordedPoint> points;
};

/// A picture that is taken as right.
struct ChartReference {
    std::string name;
    int samples = 0;
    ColorImage picture; // as RecordedPoint::picture
    Document document;
};

/// Name of a setting: method, depth, and what else differs from the scene's own: "path d5 shadows=off".
std::string nameOfSetting(const Document& original, const Document& now);

/// Used by one thread, that of the window.
class ChartRecording {
public:
    void setOn(bool on) { on_ = on; }
    bool on() const { return on_; }

    /// A picture is begun. The curves of another view, scene or size go, but for pinned ones, and so does the
    /// oldest where there are many.
    void begin(const Document& original, const Document& now, int width, int height);

    /// Takes a point whenever the number of samples has doubled, if recording is on; true for a new one. How
    /// far a pixel of b samples lies from its own earlier state of a samples tells its error: of independent
    /// samples the variance of the step is (b − a)/a times that of the mean of b.
    bool update(const RenderSession&);

    /// Ends all curves, for another scene is there.
    void clear();

    const std::vector<RecordedCurve>& curves() const { return curves_; }
    /// Index of the curve that grows; −1 for none.
    int current() const { return curves_.empty() ? -1 : static_cast<int>(curves_.size()) - 1; }

    void rename(std::size_t curve, std::string name) { curves_.at(curve).name = std::move(name); }
    void recolor(std::size_t curve, int color) { curves_.at(curve).color = color; }
    void pin(std::size_t curve, bool pinned) { curves_.at(curve).pinned = pinned; }
    /// Takes a curve away; the current one begins again with its next point.
    void remove(std::size_t curve);

    /// Takes the latest picture of a curve as right: errors are measured against it from now on, those of all
    /// points that are there too. Until the view changes. Throws InputError if the curve has no point.
    void takeReference(std::size_t curve);
    void dropReference() { reference_.reset(); }
    const std::optional<ChartReference>& reference() const { return reference_; }

    /// Curves that have points and, where there is a reference, are of its view.
    std::vector<std::size_t> drawn() const;
    /// To the reference if there is one, else as estimated.
    double errorOf(const RecordedPoint&) const;

private:
    int freeColor() const;
    double estimatedError(const ColorImage& picture, const ColorImage& counts);

    bool on_ = false;
    int width_ = 0, height_ = 0;
    std::vector<RecordedCurve> curves_;
    ColorImage last_, lastCounts_;      // the picture of the point before, and its samples
    std::vector<double> squaredErrors_; // of each pixel, as last estimated
    int lastSamples_ = 0;
    std::optional<ChartReference> reference_;
};

/// The curves drawn; the latest with its samples beside each, and the slope of Monte Carlo from its
/// first.
Plot plotOf(const ChartRecording&);

/// A line for each point.
std::string csvOf(const ChartRecording&);

}
