#pragma once
// The picked pixel, taken apart: what the views of its tree and its ledger show.

#include <vector>

#include "app/document/document.h"
#include "core/render/render_session.h"
#include "core/study/family.h"
#include "core/study/ledger.h"
#include "core/study/notation.h"
#include "core/study/tree_diagram.h"

namespace eyeray {

/// What is known of the picked pixel: one of its samples, traced again.
struct PickedSample {
    PixelPosition pixel;
    int sample = 0; // which of the pixel's samples
    Retrace trace;
    int object = -1; // what the eye ray hit
};

/// How a person looks at it.
struct StudySettings {
    bool table = false; // the tree as a table, else as a diagram
    TreeFilter filter;
    Notation notation = Notation::DeckA;
    bool flatSum = false; // the sum of a physical method as a flat list, else nested like the tree
};

class PixelStudy {
public:
    /// Takes a sample apart. What was struck out or folded stays so if it is the same sample again with an
    /// alike sum.
    void look(const PickedSample&, const Scene&);

    const StudySettings& settings() const { return settings_; }
    /// Takes effect with the next look.
    void set(const StudySettings& settings) { settings_ = settings; }

    const Ledger& ledger() const { return ledger_; }
    const Family& family() const { return family_; }
    const TreeDiagram& diagram() const { return diagram_; }

    /// Throws InputError if the ledger has no such node.
    void strike(int node, bool out);
    void restore() { strikes_.clear(); }
    const std::vector<Strike>& strikes() const { return strikes_; } // in order of their nodes
    bool isStruck(int node) const;

    /// Retraces more of the pixel's samples, until the mean has as many as the film; a share of the work at
    /// each call. True if there is something new to show.
    bool average(const RenderSession&, const PixelPosition&);
    const PixelMean& mean() const { return mean_; }
    /// What the film held when it was last looked at.
    const FilmPixel& film() const { return film_; }

private:
    StudySettings settings_;
    PixelPosition pixel_;
    int sample_ = -1;
    Ledger ledger_;
    Family family_{SampleRecord{}};
    TreeDiagram diagram_;
    std::vector<Strike> strikes_;
    PixelPosition averaged_; // the pixel of the mean
    PixelMean mean_;
    FilmPixel film_;
};

}
