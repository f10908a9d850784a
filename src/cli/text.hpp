// Numbers and sentences as people read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace cleft_cli
{

std::string grouped(int64_t number);                                   // 1,234,567
std::string rounded(double number);                                    // 1,234,567; from 1e15 on 1.2e+20
std::string decimals(double number, int digits);                       // 12.30
std::string significant(double number, int digits = 4);                // 0.001235, 1.2e+07
std::string bytes_text(double bytes);                                  // 12.3 MB
std::string seconds_text(double seconds);                              // 3.1 s, 2 min 5 s
std::string plural(int64_t count, const char* noun);                   // 1 label, 2,000 labels
std::string plural(int64_t count, const char* one, const char* many);  // 1 tetrahedron, 2,000 tetrahedra
// Lines of at most `width` characters, broken at blanks; a longer word has a line of its own.
std::string wrapped(const std::string& text, std::size_t width);
// Filled up with blanks to `width` bytes; a longer text stays as it is.
std::string left(const std::string& text, std::size_t width);
std::string right(const std::string& text, std::size_t width);

}  // namespace cleft_cli
