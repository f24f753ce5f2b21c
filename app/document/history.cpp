#include "app/document/history.h"

namespace eyeray {

void History::change(Document changed, const std::string& gesture) {
    if (gesture.empty() || gesture != gesture_) {
        before_.push_back(present_);
        if (before_.size() > kMostSteps) before_.erase(before_.begin());
    }
    after_.clear();
    gesture_ = gesture;
    present_ = std::move(changed);
}

void History::undo() {
    if (before_.empty()) return;
    after_.push_back(std::move(present_));
    present_ = std::move(before_.back());
    before_.pop_back();
    gesture_.clear();
}

void History::redo() {
    if (after_.empty()) return;
    before_.push_back(std::move(present_));
    present_ = std::move(after_.back());
    after_.pop_back();
    gesture_.clear();
}

}
