#pragma once
// Undo and redo: a stack of documents.

#include <string>
#include <vector>

#include "app/document/document.h"

namespace eyeray {

/// The present document, those before it and those undone. Changes that carry the same non-empty gesture id
/// in a row are one step, so that a drag is undone at once.
class History {
public:
    explicit History(Document start) : original_(start), present_(std::move(start)) {}

    const Document& document() const { return present_; }
    const Document& original() const { return original_; }

    /// Makes `changed` the present document.
    void change(Document changed, const std::string& gesture = {});
    /// Replaces the present document without a step, for what is no edit: selection, the picked pixel.
    void replace(Document changed) { present_ = std::move(changed); }
    /// Ends a gesture: the next change is a step of its own.
    void endGesture() { gesture_.clear(); }
    bool inGesture() const { return !gesture_.empty(); }

    bool canUndo() const { return !before_.empty(); }
    bool canRedo() const { return !after_.empty(); }
    void undo();
    void redo();

private:
    static constexpr std::size_t kMostSteps = 1000;
    Document original_, present_;
    std::vector<Document> before_, after_;
    std::string gesture_;
};

}
