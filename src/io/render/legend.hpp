// What the colours of a picture mean, at its right.
#pragma once

#include "io/render/canvas.hpp"
#include "io/render/colour_scale.hpp"

#include <optional>
#include <string>
#include <vector>

namespace cleft::io
{

struct LegendEntry {
    Colour colour;
    std::string text;
};

// Either rows, or a bar of colours.
struct Legend {
    std::vector<LegendEntry> entries;
    std::optional<ColourScale> scale;
};

// The part of a picture that its legend takes, in pixels. Names that are too long for it are cut short. A scale need
// not be there yet.
int legend_width(const Legend& legend, int width, int height);

// In the last `width` pixels of each row. Entries that have no place are counted in the last one.
void draw_legend(const Legend& legend, int width, Colour text, Canvas& canvas);

}  // namespace cleft::io
