#include "app/viewer/needs_measuring.h"

#include <algorithm>
#include <mutex>

namespace eyeray {

struct NeedsMeasuring::Steps {
    std::mutex mutex;
    std::string doing;
    std::size_t begun = 0, all = 1;
};

template <class Work>
void NeedsMeasuring::start(std::size_t steps, Work work) {
    steps_ = std::make_shared<Steps>();
    steps_->all = steps;
    job_.start([plan = plan_, steps = steps_, work = std::move(work)](const std::stop_token& stop) {
        const NeedsStep step = [&steps = *steps](const std::string& doing) {
            const std::scoped_lock lock(steps.mutex);
            steps.doing = doing;
            ++steps.begun;
        };
        return work(plan, step, stop);
    });
}

void NeedsMeasuring::measure(const Document& document, int width, int height, int threads) {
    clear();
    before_ = document;
    plan_ = needsPlan(document, width, height, false);
    plan_.threads = threads;
    start(stepsToMeasure(), measureNeeds);
}

void NeedsMeasuring::check() {
    checking_ = true;
    start(stepsToCheck(*needs_),
          [measured = *needs_](const NeedsPlan& plan, const NeedsStep& step, const std::stop_token& stop) {
              return checkNeeds(plan, measured, step, stop);
          });
}

void NeedsMeasuring::clear() {
    job_.cancel();
    needs_.reset();
    checking_ = checked_ = false;
}

bool NeedsMeasuring::update() {
    auto found = job_.take();
    if (!found || !*found) return false;
    needs_ = std::move(*found);
    checked_ = std::exchange(checking_, false);
    return true;
}

std::string NeedsMeasuring::doing() const {
    const std::scoped_lock lock(steps_->mutex);
    return steps_->doing;
}

double NeedsMeasuring::done() const {
    const std::scoped_lock lock(steps_->mutex);
    return std::clamp((static_cast<double>(steps_->begun) - 1) / static_cast<double>(steps_->all), 0.0, 1.0);
}

}
