// Writes numbers, sizes and times for people. Points and commas do not follow the locale, so that
// output is the same everywhere.
#include "text.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>

namespace cleft_cli
{

std::string grouped(int64_t number)
{
    std::string text = std::to_string(number);
    const std::size_t first = number < 0 ? 1 : 0;
    for (std::size_t place = text.size(); place > first + 3;) {
        place -= 3;
        text.insert(place, ",");
    }
    return text;
}

std::string rounded(double number)
{
    // Above it a number has more digits than anybody reads, and soon more than int64 holds.
    constexpr double kReadable = 1e15;
    return number < kReadable ? grouped(static_cast<int64_t>(std::llround(number))) : significant(number);
}

std::string decimals(double number, int digits)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", digits, number);
    // "%.2f" of 1e300 has 300 digits; the buffer holds the first of them.
    return std::fabs(number) < 1e15 ? buffer : significant(number);
}

std::string significant(double number, int digits)
{
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, number);
    return buffer;
}

std::string bytes_text(double bytes)
{
    const char* units[] = {"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    // 999.5 and 99.95 are what would be rounded to 1000 and 100.0.
    for (; bytes >= 999.5 && unit < 4; ++unit)
        bytes /= 1000;
    return decimals(bytes, unit == 0 || bytes >= 99.95 ? 0 : 1) + " " + units[unit];
}

std::string seconds_text(double seconds)
{
    if (seconds < 60)
        return decimals(seconds, seconds < 10 ? 2 : 1) + " s";
    // Rounded before it is split, so that no "1 min 60 s" comes out.
    const auto whole = static_cast<int64_t>(std::llround(seconds));
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

std::string plural(int64_t count, const char* noun) { return grouped(count) + " " + noun + (count == 1 ? "" : "s"); }

std::string plural(int64_t count, const char* one, const char* many)
{
    return grouped(count) + " " + (count == 1 ? one : many);
}

std::string wrapped(const std::string& text, std::size_t width)
{
    std::istringstream words(text);
    std::string word, lines;
    std::size_t column = 0;
    while (words >> word) {
        if (column > 0 && column + 1 + word.size() > width) {
            lines += '\n';
            column = 0;
        } else if (column > 0) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += word.size();
    }
    return lines;
}

std::string left(const std::string& text, std::size_t width)
{
    return text.size() >= width ? text : text + std::string(width - text.size(), ' ');
}

std::string right(const std::string& text, std::size_t width)
{
    return text.size() >= width ? text : std::string(width - text.size(), ' ') + text;
}

}  // namespace cleft_cli
