// What headers of text say, taken by the letter.
#include "io/header_values.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <charconv>

namespace cleft::io
{

namespace
{

constexpr std::string_view kBlanks = " \t\r\n\v\f";
// Slices of one volume in files of their own. A pattern with a larger range is a mistake, and its list would fill the
// memory.
constexpr int64_t kMostFiles = 100000;

// What is shown of a value.
std::string shown(std::string_view value)
{
    // Enough to recognise a value in a message of one line.
    constexpr size_t kLongest = 60;
    std::string text(value.substr(0, kLongest));
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ')
            c = '?';
    return text + (value.size() > kLongest ? "..." : "");
}

}  // namespace

std::string_view trimmed(std::string_view text)
{
    const size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos)
        return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

void replace_all(std::string& text, const std::string& from, const std::string& to)
{
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::vector<std::string> words_of(std::string_view text)
{
    std::vector<std::string> words;
    for (size_t begin = text.find_first_not_of(kBlanks); begin != std::string_view::npos;) {
        const size_t end = std::min(text.find_first_of(kBlanks, begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(kBlanks, end);
    }
    return words;
}

void refuse_field(std::string_view field, std::string_view value, const std::string& why)
{
    throw Error(CLEFT_ERROR_FORMAT, "its field '" + shown(field) + "' is '" + shown(value) + "': " + why);
}

int64_t integer_of(std::string_view field, std::string_view word)
{
    int64_t value = 0;
    const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(begin, end, value);
    if (result.ec != std::errc() || result.ptr != end)
        refuse_field(field, word, "a whole number is wanted");
    return value;
}

double real_of(std::string_view field, std::string_view word)
{
    double value = 0;
    const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(begin, end, value);
    // from_chars() calls both 1e999 and 1e-999 out of range.
    if (result.ec == std::errc::result_out_of_range)
        refuse_field(field, word, "the number is too large or too small for double precision");
    if (result.ec != std::errc() || result.ptr != end)
        refuse_field(field, word, "a number is wanted");
    return value;
}

namespace
{

std::vector<std::string> so_many_words(std::string_view field, std::string_view value, size_t count)
{
    std::vector<std::string> words = words_of(value);
    // More numbers than axes mean that the header and the list do not belong together, so none is
    // dropped.
    if (words.size() != count)
        refuse_field(field, value,
                     counted(static_cast<int64_t>(count), "number is", "numbers are") + " wanted, not " +
                         std::to_string(words.size()));
    return words;
}

}  // namespace

std::vector<int64_t> integers_of(std::string_view field, std::string_view value, size_t count)
{
    std::vector<int64_t> numbers;
    for (const std::string& word : so_many_words(field, value, count))
        numbers.push_back(integer_of(field, word));
    return numbers;
}

std::vector<double> reals_of(std::string_view field, std::string_view value, size_t count)
{
    std::vector<double> numbers;
    for (const std::string& word : so_many_words(field, value, count))
        numbers.push_back(real_of(field, word));
    return numbers;
}

std::vector<std::string> names_of_pattern(std::string_view field, const std::string& pattern, int64_t first,
                                          int64_t last, int64_t step)
{
    const size_t begin = pattern.find('%');
    size_t end = std::min(pattern.find_first_not_of("0123456789", begin + 1), pattern.size());
    // The pattern is never given to printf(): a header from a stranger could read memory by it.
    const bool single = begin != std::string::npos && pattern.find('%', begin + 1) == std::string::npos;
    if (!single || end == pattern.size() || pattern[end] != 'd' || end - begin > 4)
        refuse_field(field, pattern, "a name with one %d, or %03d, is wanted");
    const bool zeros = pattern[begin + 1] == '0';
    const size_t width = end == begin + 1 ? 0 : std::stoul(pattern.substr(begin + 1, end - begin - 1));
    // Sums and differences below cannot overflow.
    constexpr int64_t kGreatest = int64_t{1} << 40;
    for (const int64_t number : {first, last, step})
        if (number < -kGreatest || number > kGreatest)
            refuse_field(field, pattern, "the number " + std::to_string(number) + " is too large");
    if (step == 0 || (last - first) / step < 0 || (last - first) / step >= kMostFiles)
        refuse_field(field, pattern, "its numbers do not lead from the first to the last");
    std::vector<std::string> names;
    for (int64_t number = first; step > 0 ? number <= last : number >= last; number += step) {
        std::string digits = std::to_string(number < 0 ? -number : number);
        // As printf() does: the sign counts as part of the width.
        const size_t room = width > (number < 0 ? 1 : 0) ? width - (number < 0 ? 1 : 0) : 0;
        if (zeros && digits.size() < room)
            digits.insert(0, room - digits.size(), '0');
        digits.insert(0, number < 0 ? "-" : "");
        if (digits.size() < width)
            digits.insert(0, width - digits.size(), ' ');
        names.push_back(pattern.substr(0, begin) + digits + pattern.substr(end + 1));
    }
    return names;
}

}  // namespace cleft::io
