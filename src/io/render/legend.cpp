// Lays out and draws the legend.
#include "io/render/legend.hpp"

#include "base/number_text.hpp"
#include "base/utf8.hpp"
#include "io/render/stroke_font.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

constexpr const char* kDots = "...";

constexpr double kLeastText = 8;  // pixels; smaller letters cannot be read

// All lengths follow the height of the text, in pixels.
struct Layout {
    double text, margin, row, swatch, gap;

    explicit Layout(double text_height)
        : text(text_height), margin(1.5 * text), row(2 * text), swatch(1.4 * text), gap(0.8 * text)
    {
    }
    double beside_text() const { return 2 * margin + swatch + gap; }
    size_t rows_in(int height) const { return static_cast<size_t>(std::max(1.0, (height - 2 * margin) / row)); }
};

// As large as looks well on a picture of this height, or so small that all rows find a place, if they do.
Layout layout_for(const Legend& legend, int height)
{
    constexpr double kShare = 64;
    const double rows = static_cast<double>(legend.entries.size());
    return Layout(std::max(kLeastText, std::floor(std::min(height / kShare, height / (2 * rows + 3)))));
}

void fill(double left, double top, double width, double height, Colour colour, Canvas& canvas)
{
    const auto whole = [](double value) { return static_cast<int>(std::floor(value + 0.5)); };
    for (int y = std::max(0, whole(top)); y < std::min(canvas.height, whole(top + height)); ++y)
        for (int x = std::max(0, whole(left)); x < std::min(canvas.width, whole(left + width)); ++x)
            canvas.pixels[canvas.at(x, y)] = {colour, 255};
}

// With a thin border, so that a pale colour is seen on white.
void draw_swatch(double left, double top, double size, Colour colour, Colour text, Canvas& canvas)
{
    fill(left, top, size, size, mixed(colour, text, kWhole / 2), canvas);
    fill(left + 1, top + 1, size - 2, size - 2, colour, canvas);
}

// As much of a text as fits, with dots behind it if it is not all.
std::string shortened(const std::string& text, double height, double width)
{
    if (text_width(text, height) <= width)
        return text;
    size_t fitting = 0, too_many = text.size();
    while (fitting + 1 < too_many) {
        const size_t middle = (fitting + too_many) / 2;
        const std::string part(beginning_of(text, middle));
        (text_width(part + kDots, height) <= width ? fitting : too_many) = middle;
    }
    return std::string(beginning_of(text, fitting)) + kDots;
}

std::string more_text(size_t count) { return "and " + std::to_string(count) + " more"; }

void draw_rows(const Legend& legend, const Layout& at, double left, Colour text, Canvas& canvas)
{
    const size_t fitting = at.rows_in(canvas.height);
    const bool has_more = legend.entries.size() > fitting;
    const size_t shown = has_more ? fitting - 1 : legend.entries.size();
    const double rows = static_cast<double>(shown + (has_more ? 1 : 0));
    double top = (canvas.height - rows * at.row) / 2;
    const double text_left = left + at.margin + at.swatch + at.gap;
    const double room = canvas.width - at.margin - text_left;
    for (size_t i = 0; i < shown; ++i, top += at.row) {
        draw_swatch(left + at.margin, top + (at.row - at.swatch) / 2, at.swatch, legend.entries[i].colour, text,
                    canvas);
        draw_text(shortened(legend.entries[i].text, at.text, room), text_left, top + (at.row + at.text) / 2, at.text,
                  text, canvas);
    }
    if (has_more)
        draw_text(shortened(more_text(legend.entries.size() - shown), at.text, room), text_left,
                  top + (at.row + at.text) / 2, at.text, text, canvas);
}

void draw_bar(const ColourScale& scale, const Layout& at, double left, Colour text, Canvas& canvas)
{
    constexpr double kShare = 0.6;  // of the height of the picture
    const double height = kShare * canvas.height;
    const double top = (canvas.height - height) / 2;
    const double bar_left = left + at.margin;
    draw_text(scale.title(), bar_left, top - at.text, at.text, text, canvas);
    for (int y = 0; y < static_cast<int>(height); ++y)
        fill(bar_left, top + y, at.swatch, 1, scale.at(scale.is_range() ? 1 - (y + 0.5) / height : 0.5), canvas);
    for (const double tick : scale.ticks()) {
        const double y = top + (1 - scale.place_of(tick)) * height;
        fill(bar_left + at.swatch, y - 0.5, at.gap / 2, 1, text, canvas);
        draw_text(number_text(tick), bar_left + at.swatch + at.gap, y + at.text / 2, at.text, text, canvas);
    }
}

// For all texts as they are.
double wanted_width(const Legend& legend, const Layout& at, int height)
{
    // The longest title of a scale. Its numbers are shorter.
    double longest = legend.entries.empty() ? text_width("radius ratio", at.text) : 0;
    if (legend.entries.size() > at.rows_in(height))
        longest = text_width(more_text(legend.entries.size()), at.text);
    for (const LegendEntry& entry : legend.entries)
        longest = std::max(longest, text_width(entry.text, at.text));
    return longest + at.beside_text();
}

}  // namespace

int legend_width(const Legend& legend, int width, int height)
{
    constexpr double kMostShare = 0.4;  // of the picture
    return static_cast<int>(
        std::ceil(std::min(kMostShare * width, wanted_width(legend, layout_for(legend, height), height))));
}

void draw_legend(const Legend& legend, int width, Colour text, Canvas& canvas)
{
    const double left = canvas.width - width;
    Layout at = layout_for(legend, canvas.height);
    // Fewer rows than the width was made for may have larger text, but no wider one.
    while (at.text > kLeastText && wanted_width(legend, at, canvas.height) > width)
        at = Layout(at.text - 1);
    if (legend.scale)
        draw_bar(*legend.scale, at, left, text, canvas);
    else
        draw_rows(legend, at, left, text, canvas);
}

}  // namespace cleft::io
