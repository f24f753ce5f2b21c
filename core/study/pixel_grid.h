#pragma once
// A picture of so few pixels that a class can count them.

namespace eyeray {

/// Cells over a picture, numbered row by row from the top left. The pixel in a cell's middle stands for it.
struct PixelGrid {
    int columns = 1, rows = 1; // of cells
    int width = 2, height = 2; // of the picture, in pixels: at least two to a cell

    int cells() const { return columns * rows; }
    int column(int cell) const { return cell % columns; }
    int row(int cell) const { return cell / columns; }
    int middleX(int cell) const { return (2 * column(cell) + 1) * width / (2 * columns); }
    int middleY(int cell) const { return (2 * row(cell) + 1) * height / (2 * rows); }
    /// The cell around a pixel.
    int cellAt(int x, int y) const { return y * rows / height * columns + x * columns / width; }

    friend bool operator==(const PixelGrid&, const PixelGrid&) = default;
};

/// 16 cells along the longer side, as square as they can be: 16x12 over a picture of 4:3.
PixelGrid gridOver(int width, int height);

}
