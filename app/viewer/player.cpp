#include "app/viewer/player.h"

#include <algorithm>

namespace eyeray {
namespace {

constexpr auto kStep = std::chrono::milliseconds(700); // time to see where a ray goes, and to say it

}

int Player::shown(const SampleRecord& record) const {
    const int all = static_cast<int>(record.rays.size());
    return traced_ ? std::clamp(*traced_, std::min(1, all), all) : all;
}

void Player::go(const SampleRecord& record, PlayTo to) {
    const bool begins = !traced_ && to != PlayTo::Back;
    traced_ = played(record, shown(record), begins && to != PlayTo::End ? PlayTo::Start : to);
}

void Player::run(const SampleRecord& record, bool on, Clock::time_point now) {
    running_ = on;
    lastStep_ = now;
    if (on && shown(record) == static_cast<int>(record.rays.size())) go(record, PlayTo::Start);
}

bool Player::update(const SampleRecord& record, Clock::time_point now) {
    if (!running_ || now - lastStep_ < kStep) return false;
    lastStep_ = now;
    go(record, PlayTo::Next);
    running_ = shown(record) < static_cast<int>(record.rays.size());
    return true;
}

}
