#include "core/study/pixel_grid.h"

#include <algorithm>
#include <cmath>

namespace eyeray {
namespace {

constexpr int kCellsAlong = 16;

int cellsAlong(int side, int longer) {
    const double cells = kCellsAlong * static_cast<double>(side) / longer;
    return std::clamp(static_cast<int>(std::lround(cells)), 1, std::max(1, side / 2));
}

}

PixelGrid gridOver(int width, int height) {
    const int longer = std::max(width, height);
    return {cellsAlong(width, longer), cellsAlong(height, longer), width, height};
}

}
