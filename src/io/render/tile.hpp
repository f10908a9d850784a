// A square part of a picture with all its samples, small enough to stay near the processor.
#pragma once

#include "base/array.hpp"
#include "io/render/camera.hpp"
#include "io/render/canvas.hpp"

#include <algorithm>
#include <utility>

namespace cleft::io
{

// A triangle on the picture.
struct TileTriangle {
    ScreenPoint a, b, c;
    // How far lines reach into it from the edges ab, bc and ca, in units of ScreenPoint.
    double line_ab = 0, line_bc = 0, line_ca = 0;

    std::pair<int32_t, int32_t> extent_x() const { return std::minmax({a.x, b.x, c.x}); }
    std::pair<int32_t, int32_t> extent_y() const { return std::minmax({a.y, b.y, c.y}); }
};

struct FaceColours {
    Colour inside;
    Colour line;  // along its edges
};

class Tile
{
public:
    static constexpr int kPixels = 32;  // a side: 200 kB of samples
    static constexpr int kSamples = 4;  // along each side of a pixel

    Tile();

    // Forgets all samples, and lies from this pixel on.
    void begin(int left, int top);
    // `face` is any number from 0 on, by which end() finds the colours.
    void draw(const TileTriangle& triangle, int32_t face);
    // The means of the samples go to the canvas, as far as the tile lies on it. Faces that have a sample are marked.
    void end(const Array<FaceColours>& colours, Canvas& canvas, Array<char>& is_seen) const;

private:
    struct Sample {
        float depth;  // 0: none
        bool on_line : 1;
        uint32_t face : 31;
    };
    // Of samples, whose last is included.
    struct Span {
        int first, last;
    };
    static constexpr int kSide = kPixels * kSamples;
    static constexpr int32_t kStep = ScreenPoint::kUnits / kSamples;

    static Span span(std::pair<int32_t, int32_t> extent, int32_t origin);
    void end_pixel(int x, int y, const Array<FaceColours>& colours, Pixel& pixel, float& depth,
                   Array<char>& is_seen) const;

    int32_t origin_x_ = 0, origin_y_ = 0;
    int left_ = 0, top_ = 0;
    Array<Sample> samples_;
};

}  // namespace cleft::io
