// Finds creases in the depths of a picture.
//
// The depth of a plane is linear on the picture. The mean of two depths on opposite sides of a pixel is thus that of
// the pixel on a plane, nearer to the eye in a crease, and farther on a ridge. Creases are darkened, for all directions
// and several distances on the picture.
#include "io/render/creases.hpp"

#include "base/reported_loop.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

// Places at distance 1 in steps of 22.5 degrees, for half of the circle; the other half is opposite.
constexpr double kDirections[][2] = {{1, 0},         {0.707, 0.707}, {0, 1},          {-0.707, 0.707},
                                     {0.924, 0.383}, {0.383, 0.924}, {-0.383, 0.924}, {-0.924, 0.383}};
// Distances as shares of the shorter side of the picture: the least shows the crevices between single tetrahedra, the
// greatest how the whole lies. Four directions each, by turns, so that no ring is seen.
constexpr double kDistances[] = {0.0025, 0.004, 0.0060, 0.0085, 0.0115, 0.015, 0.0190, 0.0235};
constexpr size_t kDistanceCount = sizeof kDistances / sizeof *kDistances;
constexpr size_t kPairsAtOne = 4;
constexpr double kPairs = kPairsAtOne * kDistanceCount;
constexpr double kDarkest = 0.7;  // of the colour is taken away where all directions meet a wall
constexpr Colour kDeep{16, 18, 34};

// Steps on the canvas to one of two opposite places, and how far the depth may differ there before it is another part
// of the mesh, which says nothing about this one.
struct OppositePlaces {
    int x, y;
    float reach;
};

Array<OppositePlaces> pairs_for(const Canvas& canvas, double pixels_per_unit)
{
    Array<OppositePlaces> pairs;
    for (size_t d = 0; d < kDistanceCount; ++d)
        for (size_t i = 0; i < kPairsAtOne; ++i) {
            const auto& direction = kDirections[d % 2 * kPairsAtOne + i];
            const double pixels = std::max(1.0, kDistances[d] * std::min(canvas.width, canvas.height));
            const auto rounded = [&](double value) { return static_cast<int>(std::floor(value * pixels + 0.5)); };
            pairs.push_back(
                {rounded(direction[0]), rounded(direction[1]), static_cast<float>(pixels / pixels_per_unit)});
        }
    return pairs;
}

// 0 to 1: how much of the light from around is kept away.
double kept_away(const Canvas& canvas, int x, int y, const Array<OppositePlaces>& pairs)
{
    const float here = canvas.depth[canvas.at(x, y)];
    double sum = 0;
    for (const OppositePlaces& pair : pairs) {
        const auto higher = [&](int dx, int dy) {
            if (!canvas.has(x + dx, y + dy))
                return 0.0F;
            return std::clamp(canvas.depth[canvas.at(x + dx, y + dy)] - here, -pair.reach, pair.reach);
        };
        const float crease = higher(pair.x, pair.y) + higher(-pair.x, -pair.y);
        if (crease > 0)
            sum += double(std::min(crease, pair.reach)) / double(pair.reach);
    }
    return sum / kPairs;
}

}  // namespace

void darken_creases(double pixels_per_unit, const Run& run, Canvas& canvas)
{
    const Array<OppositePlaces> pairs = pairs_for(canvas, pixels_per_unit);
    constexpr int64_t kRows = 8;
    reported_for(run, canvas.height, kRows, [&](int64_t begin, int64_t end) {
        for (int y = static_cast<int>(begin); y < end; ++y)
            for (int x = 0; x < canvas.width; ++x) {
                Pixel& pixel = canvas.pixels[canvas.at(x, y)];
                if (pixel.cover == 0)
                    continue;
                const double share = kDarkest * kept_away(canvas, x, y, pairs);
                pixel.colour = mixed(pixel.colour, kDeep, static_cast<int>(share * kWhole));
            }
    });
}

}  // namespace cleft::io
