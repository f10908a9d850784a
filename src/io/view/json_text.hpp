// JSON that may stand inside a page: no text in it can end the element that it stands in.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace cleft::io
{

// A string of JSON with its quotes. "<" is written as an escape, so that no "</script>" can arise. What is not UTF-8
// becomes the sign for it (U+FFFD).
std::string json_string(std::string_view text);

// The same JSON without any "<". In JSON that sign stands in strings alone, where its escape means the same.
std::string without_tags(std::string_view json);

// Text as HTML, for an element or a quoted attribute.
std::string html_text(std::string_view text);

// Writes a value, field by field. Commas come by themselves.
class JsonText
{
public:
    JsonText& open(char bracket);
    JsonText& close(char bracket);
    JsonText& key(std::string_view name);
    JsonText& value(std::string_view text);
    JsonText& value(const char* text) { return value(std::string_view(text)); }
    // The fewest digits that give the same number back; null for what is not finite.
    JsonText& value(double number);
    template <class Integer, class = std::enable_if_t<std::is_integral_v<Integer>>>
    JsonText& value(Integer number)
    {
        return raw(std::to_string(number));
    }
    template <class T>
    JsonText& field(std::string_view name, const T& of)
    {
        return key(name).value(of);
    }
    // [1,2,3]
    template <class Numbers>
    JsonText& list(std::string_view name, const Numbers& numbers)
    {
        key(name).open('[');
        for (const auto& number : numbers)
            value(number);
        return close(']');
    }

    const std::string& text() const { return text_; }

private:
    JsonText& raw(std::string_view text);
    void separate();

    std::string text_;
    bool is_first_ = true;  // in its object or array, or behind its key
};

}  // namespace cleft::io
