// Writes bytes as base64: three bytes are four letters.
#include "io/view/base64.hpp"

#include <cstdint>

namespace cleft::io
{

std::string to_base64(std::string_view bytes)
{
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    constexpr char kPadding = '=';
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t b = 0; b < 3; ++b)
            three = three << 8 | (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0U);
        for (size_t letter = 0; letter < 4; ++letter)
            // One byte gives two letters, two give three.
            text += i + letter > bytes.size() ? kPadding : kLetters[three >> (18 - 6 * letter) & 63U];
    }
    return text;
}

}  // namespace cleft::io
