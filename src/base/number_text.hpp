// Numbers in sentences for the user: none overflows, and none is shown as 0 that is not.
// Points do not follow the locale of the caller's program, which printf() does.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace cleft
{

// As C's "%.*g" and "%.*f" in its own locale, of numbers below 1e15 where there are decimals.
inline std::string text_as(double value, std::chars_format format, int precision)
{
    std::array<char, 64> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value, format, precision);
    return {text.data(), result.ptr};
}

inline std::string digits_text(double value, int digits) { return text_as(value, std::chars_format::general, digits); }

inline std::string decimals_text(double value, int decimals)
{
    return text_as(value, std::chars_format::fixed, decimals);
}

// "2.5", with ten digits at most.
inline std::string text_of(double value) { return digits_text(value, 10); }

// A measured figure, "0.25", "3.1e-12": six digits are enough to find it again.
inline std::string number_text(double value) { return digits_text(value, 6); }

// A whole number, "123456"; one that is too long to read, "3.1e+20".
inline std::string count_text(double count)
{
    // Every whole number up to it is exact in a double, so no digit that is shown is made up.
    constexpr double kReadable = 1e15;
    return std::abs(count) < kReadable ? decimals_text(std::round(count), 0) : digits_text(std::round(count), 3);
}

}  // namespace cleft
