// Letters of ASCII. The functions of <cctype> follow the locale of the caller's program, and a file must not.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace cleft::io
{

inline bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

inline std::string in_small_letters(std::string_view text)
{
    std::string small(text);
    std::transform(small.begin(), small.end(), small.begin(),
                   [](char c) { return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c; });
    return small;
}

inline std::string in_capitals(std::string_view text)
{
    std::string capital(text);
    std::transform(capital.begin(), capital.end(), capital.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return capital;
}

}  // namespace cleft::io
