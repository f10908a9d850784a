// Numbers in sentences.
#pragma once

#include <array>
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

}  // namespace cleft
