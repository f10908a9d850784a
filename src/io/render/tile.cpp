// Draws triangles into the samples of one tile.
#include "io/render/tile.hpp"

#include <cmath>

namespace cleft::io
{

namespace
{

// The line through two corners: above 0 on the inner side, in units of ScreenPoint squared.
// Corners lie within 2^30 units, so products fit 64 bits.
struct Side {
    int64_t start, step_x, step_y;
    int64_t line;  // on the line if below it

    Side(const ScreenPoint& from, const ScreenPoint& to, int64_t x, int64_t y, int32_t step, double reach)
    {
        const int64_t dx = int64_t{to.x} - from.x;
        const int64_t dy = int64_t{to.y} - from.y;
        // A sample on the edge belongs to the triangle for which the edge runs downwards, or to the right. For the
        // other one it runs the other way.
        const bool has_edge = dy > 0 || (dy == 0 && dx > 0);
        start = dx * (y - from.y) - dy * (x - from.x) - (has_edge ? 0 : 1);
        step_x = -dy * step;
        step_y = dx * step;
        const double length = std::sqrt(static_cast<double>(dx) * static_cast<double>(dx) +
                                        static_cast<double>(dy) * static_cast<double>(dy));
        line = static_cast<int64_t>(reach * length);
    }
};

// The depth over the tile: that of a plane, and never beyond those of the corners.
struct Slope {
    double start, step_x, step_y;
    float least, greatest;

    Slope(const TileTriangle& t, double two_areas, int64_t x, int64_t y, int32_t step)
    {
        const double bx = double(t.b.x) - t.a.x, by = double(t.b.y) - t.a.y;
        const double cx = double(t.c.x) - t.a.x, cy = double(t.c.y) - t.a.y;
        const double b = double(t.b.depth) - double(t.a.depth);
        const double c = double(t.c.depth) - double(t.a.depth);
        const double by_x = (b * cy - c * by) / two_areas;
        const double by_y = (c * bx - b * cx) / two_areas;
        start = double(t.a.depth) + by_x * static_cast<double>(x - t.a.x) + by_y * static_cast<double>(y - t.a.y);
        step_x = by_x * step;
        step_y = by_y * step;
        std::tie(least, greatest) = std::minmax({t.a.depth, t.b.depth, t.c.depth});
    }

    float at(int x, int y) const
    {
        return std::clamp(static_cast<float>(start + step_x * x + step_y * y), least, greatest);
    }
};

// Twice the area, above 0 where the corners run clockwise on the picture.
int64_t two_areas_of(const TileTriangle& t)
{
    return (int64_t{t.b.x} - t.a.x) * (int64_t{t.c.y} - t.a.y) - (int64_t{t.b.y} - t.a.y) * (int64_t{t.c.x} - t.a.x);
}

}  // namespace

Tile::Tile() : samples_(kSide * kSide) {}

void Tile::begin(int left, int top)
{
    left_ = left;
    top_ = top;
    // The first sample lies in the middle of its part of the pixel.
    origin_x_ = left * ScreenPoint::kUnits + kStep / 2;
    origin_y_ = top * ScreenPoint::kUnits + kStep / 2;
    std::fill(samples_.begin(), samples_.end(), Sample{0, false, 0});
}

Tile::Span Tile::span(std::pair<int32_t, int32_t> extent, int32_t origin)
{
    // Clamped before the division, so that it is one of numbers above 0, and rounds down.
    const auto clamped = [&](int32_t value) {
        return std::clamp<int64_t>(int64_t{value} - origin, -kStep, int64_t{kSide} * kStep) + kStep;
    };
    const int first = static_cast<int>((clamped(extent.first) + kStep - 1) / kStep) - 1;
    const int last = static_cast<int>(clamped(extent.second) / kStep) - 1;
    return {std::max(first, 0), std::min(last, kSide - 1)};
}

void Tile::draw(const TileTriangle& triangle, int32_t face)
{
    const Span across = span(triangle.extent_x(), origin_x_);
    const Span down = span(triangle.extent_y(), origin_y_);
    const int64_t two_areas = two_areas_of(triangle);
    if (across.first > across.last || down.first > down.last || two_areas == 0)
        return;
    const TileTriangle t =
        two_areas > 0 ? triangle : TileTriangle{triangle.a,       triangle.c,       triangle.b,
                                                triangle.line_ca, triangle.line_bc, triangle.line_ab};
    const int64_t x = origin_x_, y = origin_y_;
    const Side sides[] = {
        {t.a, t.b, x, y, kStep, t.line_ab}, {t.b, t.c, x, y, kStep, t.line_bc}, {t.c, t.a, x, y, kStep, t.line_ca}};
    const Slope slope(t, std::abs(static_cast<double>(two_areas)), x, y, kStep);
    for (int row = down.first; row <= down.last; ++row) {
        int64_t at[3];
        for (int s = 0; s < 3; ++s)
            at[s] = sides[s].start + sides[s].step_y * row + sides[s].step_x * across.first;
        Sample* sample = samples_.data() + row * kSide + across.first;
        for (int column = across.first; column <= across.last; ++column, ++sample) {
            if ((at[0] | at[1] | at[2]) >= 0)
                if (const float depth = slope.at(column, row); depth > sample->depth) {
                    const bool on_line = at[0] < sides[0].line || at[1] < sides[1].line || at[2] < sides[2].line;
                    *sample = {depth, on_line, static_cast<uint32_t>(face) & 0x7FFFFFFFU};
                }
            for (int s = 0; s < 3; ++s)
                at[s] += sides[s].step_x;
        }
    }
}

void Tile::end_pixel(int x, int y, const Array<FaceColours>& colours, Pixel& pixel, float& depth,
                     Array<char>& is_seen) const
{
    int count = 0, red = 0, green = 0, blue = 0;
    double sum = 0;
    for (int row = 0; row < kSamples; ++row)
        for (int column = 0; column < kSamples; ++column) {
            const Sample& sample = samples_[(y * kSamples + row) * kSide + x * kSamples + column];
            if (sample.depth == 0)
                continue;
            const uint32_t face = sample.face;
            const Colour colour = sample.on_line ? colours[face].line : colours[face].inside;
            is_seen[face] = 1;
            ++count;
            red += colour.red;
            green += colour.green;
            blue += colour.blue;
            sum += double(sample.depth);
        }
    if (count == 0)
        return;
    const auto mean = [&](int total) { return static_cast<uint8_t>((total + count / 2) / count); };
    constexpr int kAll = kSamples * kSamples;
    pixel = {{mean(red), mean(green), mean(blue)}, static_cast<uint8_t>((count * 255 + kAll / 2) / kAll)};
    depth = static_cast<float>(sum / count);
}

void Tile::end(const Array<FaceColours>& colours, Canvas& canvas, Array<char>& is_seen) const
{
    for (int y = 0; y < kPixels && top_ + y < canvas.height; ++y)
        for (int x = 0; x < kPixels && left_ + x < canvas.width; ++x) {
            const int64_t at = canvas.at(left_ + x, top_ + y);
            end_pixel(x, y, colours, canvas.pixels[at], canvas.depth[at], is_seen);
        }
}

}  // namespace cleft::io
