// The letters and how they are drawn.
#include "io/render/stroke_font.hpp"

#include "base/utf8.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace cleft::io
{

namespace
{

// From blank to tilde. A letter is strokes between slashes, a stroke is corners between blanks, a corner a digit for
// its place to the right and a letter for its height: e is the line that letters stand on, m the height of small
// letters, q that of capitals. Ours.
constexpr const char* kStrokes[] = {
    "",
    "4i 4q/4e 4f",
    "2q 2m/6q 6m",
    "2e 3q/5e 6q/0i 8i/0m 8m",
    "8n 6p 2p 0n 0m 2k 6k 8i 8h 6f 2f 0h/4d 4r",
    "0q 2q 2o 0o 0q/6g 8g 8e 6e 6g/0e 8q",
    "8e 1n 1p 2q 4q 5p 5n 0i 0g 2e 5e 8i",
    "4q 4m",
    "5r 3o 3g 5d",
    "3r 5o 5g 3d",
    "4o 4g/1m 7i/7m 1i",
    "4g 4m/1j 7j",
    "4f 3c",
    "1j 7j",
    "4e 4f",
    "1d 7r",
    "2e 0g 0o 2q 6q 8o 8g 6e 2e",
    "1n 4q 4e/1e 7e",
    "0o 2q 6q 8o 8m 0e 8e",
    "0o 2q 6q 8o 8m 6k 8i 8g 6e 2e 0g/3k 6k",
    "6e 6q 0h 8h",
    "8q 1q 0k 2l 6l 8j 8g 6e 2e 0g",
    "7q 3q 0n 0g 2e 6e 8g 8j 6l 2l 0j",
    "0q 8q 3e",
    "2k 0m 0o 2q 6q 8o 8m 6k 2k 0i 0g 2e 6e 8g 8i 6k",
    "1e 5e 8h 8o 6q 2q 0o 0l 2j 6j 8l",
    "4g 4h/4l 4m",
    "4g 3d/4l 4m",
    "7n 1j 7f",
    "1l 7l/1h 7h",
    "1n 7j 1f",
    "0o 2q 6q 8o 8m 4j 4h/4e 4f",
    "6h 6m 3m 2l 2i 3h 6h 8i 8o 6q 2q 0o 0g 2e 7e",
    "0e 4q 8e/1i 7i",
    "0e 0q 6q 8o 8m 6k 0k/6k 8i 8g 6e 0e",
    "8o 6q 2q 0o 0g 2e 6e 8g",
    "0e 0q 5q 8n 8h 5e 0e",
    "8q 0q 0e 8e/0k 6k",
    "8q 0q 0e/0k 6k",
    "8o 6q 2q 0o 0g 2e 6e 8g 8k 5k",
    "0e 0q/8e 8q/0k 8k",
    "2q 6q/4q 4e/2e 6e",
    "7q 7g 5e 2e 0g",
    "0e 0q/8q 0j/2l 8e",
    "0q 0e 8e",
    "0e 0q 4k 8q 8e",
    "0e 0q 8e 8q",
    "2e 0g 0o 2q 6q 8o 8g 6e 2e",
    "0e 0q 6q 8o 8l 6j 0j",
    "2e 0g 0o 2q 6q 8o 8g 6e 2e/5h 8e",
    "0e 0q 6q 8o 8l 6j 0j/4j 8e",
    "8o 6q 2q 0o 0m 2k 6k 8i 8g 6e 2e 0g",
    "0q 8q/4q 4e",
    "0q 0g 2e 6e 8g 8q",
    "0q 4e 8q",
    "0q 2e 4n 6e 8q",
    "0e 8q/0q 8e",
    "0q 4k 8q/4k 4e",
    "0q 8q 0e 8e",
    "6r 3r 3d 6d",
    "1r 7d",
    "2r 5r 5d 2d",
    "1n 4q 7n",
    "0d 8d",
    "3q 5o",
    "1m 5m 7k 7e/7i 2i 0h 0f 1e 5e 7g",
    "0q 0e/0k 2m 5m 7k 7g 5e 2e 0g",
    "7l 5m 2m 0k 0g 2e 5e 7f",
    "7q 7e/7k 5m 2m 0k 0g 2e 5e 7g",
    "0i 7i 7k 5m 2m 0k 0g 2e 6e 7f",
    "6q 4q 3p 3e/1m 5m",
    "7m 7d 5b 2b 0c/7k 5m 2m 0k 0g 2e 5e 7g",
    "0q 0e/0k 2m 5m 7k 7e",
    "4m 4e/4p 4q",
    "4m 4d 3b 1b/4p 4q",
    "0q 0e/6m 0h/2j 7e",
    "4q 4e",
    "0e 0m/0k 2m 3m 4k 4e/4k 6m 7m 8k 8e",
    "0m 0e/0k 2m 5m 7k 7e",
    "2e 0g 0k 2m 5m 7k 7g 5e 2e",
    "0m 0b/0k 2m 5m 7k 7g 5e 2e 0g",
    "7m 7b/7k 5m 2m 0k 0g 2e 5e 7g",
    "0m 0e/0k 2m 5m",
    "7l 5m 1m 0l 0k 1j 6i 7h 7g 6e 1e 0f",
    "3p 3g 4e 6e/1m 6m",
    "0m 0g 2e 5e 7g/7m 7e",
    "0m 3e 6m",
    "0m 2e 4k 6e 8m",
    "0m 7e/7m 0e",
    "0m 3f/7m 3c 1b",
    "0m 7m 0e 7e",
    "6r 4q 4l 2j 4i 4e 6d",
    "4r 4d",
    "2r 4q 4l 6j 4i 4e 2d",
    "0i 2k 5i 7k",
};
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

Letter letter_of(uint32_t code)
{
    const bool is_known = code >= ' ' && code <= '~';
    const std::string_view strokes = kStrokes[(is_known ? code : '?') - ' '];
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

std::vector<Letter> letters_of(std::string_view text)
{
    std::vector<Letter> letters;
    while (!text.empty()) {
        const Character next = first_character(text);
        letters.push_back(letter_of(next.code));
        text.remove_prefix(std::max<size_t>(next.bytes, 1));
    }
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
    const int first_x = static_cast<int>(std::floor(left - pixels)), first_y = static_cast<int>(base - 14 * pixels);
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
