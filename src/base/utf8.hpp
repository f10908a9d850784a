// Text in UTF-8: its characters, and what may stand in a sentence.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cleft
{

struct Character {
    uint32_t code = 0;
    size_t bytes = 0;  // 0: not UTF-8

    // Line breaks, and what else controls a terminal.
    bool is_control() const { return code < 0x20 || (code >= 0x7F && code < 0xA0); }
};

// The character at the start of a text, which is not empty: not too long a form, no surrogate, nothing beyond Unicode.
inline Character first_character(std::string_view text)
{
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return {lead, 1};
    const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    constexpr uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
    if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes)
        return {};
    uint32_t code = lead & (0x7FU >> bytes);
    for (size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80)
            return {};
        code = code << 6 | (byte(i) & 0x3FU);
    }
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < kLeast[bytes] || surrogate || code > 0x10FFFF ? Character{} : Character{code, bytes};
}

// The beginning of a text of UTF-8 that has no more than so many bytes, and only whole characters.
inline std::string_view beginning_of(std::string_view text, size_t bytes)
{
    if (text.size() <= bytes)
        return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80)
        --bytes;
    return text.substr(0, bytes);
}

// Calls put(characters) for a text from outside, which may be no text, until that is false. What a sentence cannot have
// is a question mark.
template <class Put>
void for_each_printable(std::string_view text, const Put& put)
{
    while (!text.empty()) {
        const Character next = first_character(text);
        const bool is_plain = next.bytes > 0 && !next.is_control();
        if (!put(is_plain ? text.substr(0, next.bytes) : std::string_view("?")))
            return;
        text.remove_prefix(std::max<size_t>(next.bytes, 1));
    }
}

inline std::string printable(std::string_view text)
{
    std::string clean;
    for_each_printable(text, [&](std::string_view character) {
        clean += character;
        return true;
    });
    return clean;
}

}  // namespace cleft
