#include "app/viewer/player.h"

#include <algorithm>

namespace eyeray {

int Player::shown(const SampleRecord& record) const {
    const int all = static_cast<int>(record.rays.size());
    return traced_ ? std::clamp(*traced_, std::min(1, all), all) : all;
}

void Player::go(const SampleRecord& record, PlayTo to) {
    const bool begins = !traced_ && to != PlayTo::Back;
    traced_ = played(record, shown(record), begins && to != PlayTo::End ? PlayTo::Start : to);
}

void Player::run(const SampleRecord& record, bool on, Clock::time_point now) {
    clock_.run(on, now);
    if (on && shown(record) == static_cast<int>(record.rays.size())) go(record, PlayTo::Start);
}

bool Player::update(const SampleRecord& record, Clock::time_point now) {
    const int steps = clock_.due(now);
    for (int i = 0; i < steps; ++i) go(record, PlayTo::Next);
    if (shown(record) == static_cast<int>(record.rays.size())) clock_.run(false);
    return steps > 0;
}

}
