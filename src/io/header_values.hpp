// Values of fields of headers: numbers and words, read strictly. Every Error names the field and what stands there.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

// A text in front of voxels that is longer than this is no header: 64 MB are far beyond any list of slices. It bounds
// the time that a binary file with the mark of a text format can take.
constexpr uintmax_t kLongestTextHeader = uintmax_t{1} << 26;

// The text without blanks at its ends. The view is of the same characters.
std::string_view trimmed(std::string_view text);
void replace_all(std::string& text, const std::string& from, const std::string& to);
std::vector<std::string> words_of(std::string_view text);

// Throws Error(CLEFT_ERROR_FORMAT) with field, value (shortened) and reason.
[[noreturn]] void refuse_field(std::string_view field, std::string_view value, const std::string& why);

// The whole word must be the number; a leading plus sign is allowed.
int64_t integer_of(std::string_view field, std::string_view word);
// May be infinite or no number; hexadecimal is not read.
double real_of(std::string_view field, std::string_view word);
// So many numbers and no more.
std::vector<int64_t> integers_of(std::string_view field, std::string_view value, size_t count);
std::vector<double> reals_of(std::string_view field, std::string_view value, size_t count);

// The names that a pattern with one %d (or %3d, %03d) stands for, from `first` to `last`. `field` is for Errors.
std::vector<std::string> names_of_pattern(std::string_view field, const std::string& pattern, int64_t first,
                                          int64_t last, int64_t step);

}  // namespace cleft::io
