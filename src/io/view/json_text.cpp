// Writes JSON and HTML so that names from files are text and never markup.
#include "io/view/json_text.hpp"

#include "base/utf8.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace cleft::io
{

namespace
{

constexpr std::string_view kNoCharacter = "\xEF\xBF\xBD";  // U+FFFD

// Calls put(code, bytes) for each character.
template <class Put>
void each_character(std::string_view text, const Put& put)
{
    while (!text.empty()) {
        const Character next = first_character(text);
        if (next.bytes == 0)
            put(0xFFFDU, kNoCharacter);
        else
            put(next.code, text.substr(0, next.bytes));
        text.remove_prefix(std::max<size_t>(next.bytes, 1));
    }
}

std::string escape(uint32_t code)
{
    char buffer[8];  // "\u003c" and its end
    std::snprintf(buffer, sizeof buffer, "\\u%04x", code & 0xFFFFU);
    return buffer;
}

}  // namespace

std::string json_string(std::string_view text)
{
    std::string out = "\"";
    each_character(text, [&](uint32_t code, std::string_view bytes) {
        if (code == '"' || code == '\\')
            out += '\\';
        if (code < 0x20 || code == '<')
            out += escape(code);
        else
            out += bytes;
    });
    return out + "\"";
}

std::string without_tags(std::string_view json)
{
    std::string out;
    each_character(json, [&](uint32_t code, std::string_view bytes) {
        if (code == '<')
            out += escape(code);
        else
            out += bytes;
    });
    return out;
}

std::string html_text(std::string_view text)
{
    std::string out;
    each_character(text, [&](uint32_t code, std::string_view bytes) {
        if (code == '<' || code == '>' || code == '&' || code == '"' || code == '\'')
            out += "&#" + std::to_string(code) + ";";
        // A zero is no character of HTML.
        else if (code != 0)
            out += bytes;
    });
    return out;
}

JsonText& JsonText::open(char bracket)
{
    separate();
    text_ += bracket;
    is_first_ = true;
    return *this;
}

JsonText& JsonText::close(char bracket)
{
    text_ += bracket;
    is_first_ = false;
    return *this;
}

JsonText& JsonText::key(std::string_view name)
{
    raw(json_string(name));
    text_ += ':';
    is_first_ = true;
    return *this;
}

JsonText& JsonText::value(std::string_view text) { return raw(json_string(text)); }

JsonText& JsonText::value(double number)
{
    if (!std::isfinite(number))
        return raw("null");
    char buffer[32];  // a double has 24 characters at most
    return raw({buffer, static_cast<size_t>(std::to_chars(buffer, buffer + sizeof buffer, number).ptr - buffer)});
}

JsonText& JsonText::raw(std::string_view text)
{
    separate();
    text_ += text;
    return *this;
}

void JsonText::separate()
{
    if (!is_first_)
        text_ += ',';
    is_first_ = false;
}

}  // namespace cleft::io
