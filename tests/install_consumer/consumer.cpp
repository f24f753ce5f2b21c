#include "core/base/sampling.h"

/// Succeeds when the library answers as its header says: pass 0 samples the middle of the pixel.
int main() {
    const eyeray::Vec2 sample = eyeray::pixelSample({.seed = 1, .x = 2, .y = 3, .pass = 0});
    return sample == eyeray::Vec2(0.5F) ? 0 : 1;
}
