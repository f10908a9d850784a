// Letters are drawn by the distance of samples from their strokes.
#include "io/render/stroke_font.hpp"

#include "base/utf8.hpp"
#include "io/render/letter_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace cleft::io
{

namespace
{

constexpr int kCapital = 12;      // steps from e to q
constexpr int kGap = 4;           // steps between letters
constexpr int kBlank = 5;         // the width of a blank beside its gaps
constexpr double kStroke = 0.13;  // its width, of the height of capitals; thinner lines fade in small text

struct StrokePart {
    double x0, y0, x1, y1;  // to the right and upwards, in steps
};

struct Letter {
    std::vector<StrokePart> parts;
    double left = 0, right = kBlank;
};

Letter letter_of(std::string_view strokes)
{
    Letter letter;
    for (size_t i = 0; i + 4 < strokes.size(); i += 3)
        if (strokes[i + 2] == ' ')  // no slash, so the stroke goes on
            letter.parts.push_back({double(strokes[i] - '0'), double(strokes[i + 1] - 'e'),
                                    double(strokes[i + 3] - '0'), double(strokes[i + 4] - 'e')});
    if (letter.parts.empty())
        return letter;
    letter.left = kCapital;
    letter.right = 0;
    for (const StrokePart& s : letter.parts) {
        letter.left = std::min({letter.left, s.x0, s.x1});
        letter.right = std::max({letter.right, s.x0, s.x1});
    }
    return letter;
}

// The strokes of each letter; nothing for what we have no strokes for.
std::vector<std::optional<std::string>> strokes_of_all(std::string_view text)
{
    std::vector<std::optional<std::string>> all;
    while (!text.empty()) {
        const Character next = first_character(text);
        text.remove_prefix(std::max<size_t>(next.bytes, 1));
        std::optional<std::string> with;
        if (!all.empty() && all.back())
            with = with_mark(*all.back(), next.code);
        if (with)
            all.back() = with;
        else
            all.push_back(next.bytes == 0 ? std::nullopt : strokes_of(next.code));
    }
    return all;
}

std::vector<Letter> letters_of(std::string_view text)
{
    std::vector<Letter> letters;
    for (const auto& strokes : strokes_of_all(text))
        letters.push_back(letter_of(strokes ? *strokes : *strokes_of('?')));
    return letters;
}

// Squared, of a place from a part.
double distance2(double x, double y, const StrokePart& s)
{
    const double dx = s.x1 - s.x0, dy = s.y1 - s.y0;
    const double along = ((x - s.x0) * dx + (y - s.y0) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(along, 0.0, 1.0);
    const double rx = x - s.x0 - t * dx, ry = y - s.y0 - t * dy;
    return rx * rx + ry * ry;
}

// Samples of a pixel that are within half the width of a stroke of one, of 16.
int samples_on(double x, double y, double step, const Letter& letter)
{
    constexpr double kHalf = kStroke * kCapital / 2;
    int count = 0;
    for (int sample = 0; sample < 16; ++sample) {
        const int column = sample % 4, row = sample / 4;
        const double sx = x + (column + 0.5) / 4 * step;
        const double sy = y - (row + 0.5) / 4 * step;
        count += std::any_of(letter.parts.begin(), letter.parts.end(),
                             [&](const StrokePart& part) { return distance2(sx, sy, part) <= kHalf * kHalf; });
    }
    return count;
}

void draw_letter(const Letter& letter, double left, double base, double pixels, Colour colour, Canvas& canvas)
{
    const int first_x = static_cast<int>(std::floor(left - pixels)), first_y = static_cast<int>(base - 18 * pixels);
    const int last_x = static_cast<int>(std::ceil(left + (letter.right - letter.left + 1) * pixels));
    const int last_y = static_cast<int>(std::ceil(base + 4 * pixels));
    for (int y = std::max(0, first_y); y <= std::min(canvas.height - 1, last_y); ++y)
        for (int x = std::max(0, first_x); x <= std::min(canvas.width - 1, last_x); ++x) {
            const int count = samples_on((x - left) / pixels + letter.left, (base - y) / pixels, 1 / pixels, letter);
            Pixel& pixel = canvas.pixels[canvas.at(x, y)];
            // On a pixel without any cover the colour behind is of no meaning.
            pixel.colour = pixel.cover == 0 && count > 0 ? colour : mixed(pixel.colour, colour, count * kWhole / 16);
            pixel.cover = static_cast<uint8_t>(std::max<int>(pixel.cover, count * 255 / 16));
        }
}

}  // namespace

bool can_draw(const std::string& text)
{
    const auto all = strokes_of_all(text);
    return std::all_of(all.begin(), all.end(), [](const auto& strokes) { return strokes.has_value(); });
}

double text_width(const std::string& text, double height)
{
    double steps = 0;
    for (const Letter& letter : letters_of(text))
        steps += letter.right - letter.left + kGap;
    return steps > 0 ? (steps - kGap) * height / kCapital : 0;
}

void draw_text(const std::string& text, double left, double base, double height, Colour colour, Canvas& canvas)
{
    const double pixels = height / kCapital;
    for (const Letter& letter : letters_of(text)) {
        draw_letter(letter, left, base, pixels, colour, canvas);
        left += (letter.right - letter.left + kGap) * pixels;
    }
}

}  // namespace cleft::io
