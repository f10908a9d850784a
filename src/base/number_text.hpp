// Numbers in sentences for the user: none overflows, and none is shown as 0 that is not.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace cleft
{

// "2.5", with ten digits at most.
inline std::string text_of(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.10g", value);
    return text.data();
}

// A measured figure, "0.25", "3.1e-12": six digits are enough to find it again.
inline std::string number_text(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

// A whole number, "123456"; one that is too long to read, "3.1e+20".
inline std::string count_text(double count)
{
    // Every whole number up to it is exact in a double, so no digit that is shown is made up.
    constexpr double kReadable = 1e15;
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), std::abs(count) < kReadable ? "%.0f" : "%.3g", std::round(count));
    return text.data();
}

}  // namespace cleft
