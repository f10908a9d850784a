// A picture in the making: the colour, the cover and the depth of each pixel.
#pragma once

#include "base/array.hpp"
#include "io/colour.hpp"

#include <cstdint>

namespace cleft::io
{

struct Pixel {
    Colour colour;
    uint8_t cover = 0;  // of the pixel by the mesh: 0 to 255
};

// Rows from the top, pixels from the left.
struct Canvas {
    int width = 0, height = 0;
    Array<Pixel> pixels;
    Array<float> depth;  // mean of what covers the pixel, as in ScreenPoint; 0 where nothing does

    Canvas(int width_in_pixels, int height_in_pixels)
        : width(width_in_pixels),
          height(height_in_pixels),
          pixels(int64_t{width} * height),
          depth(int64_t{width} * height)
    {
    }
    bool has(int x, int y) const { return x >= 0 && x < width && y >= 0 && y < height; }
    int64_t at(int x, int y) const { return int64_t{y} * width + x; }
};

}  // namespace cleft::io
