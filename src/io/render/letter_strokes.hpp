// The strokes that letters are made of: ASCII, Latin letters with marks, and Greek.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cleft::io
{

// Strokes lie between slashes, a stroke is corners between blanks, a corner a digit for its place to the right and a
// letter for its height: e is the line that letters stand on, m the height of small letters, q that of capitals.
// Nothing if we have no such letter.
std::optional<std::string> strokes_of(uint32_t code);

// `letter` with a mark that follows it as a character of its own, as in decomposed text; nothing if `code` is no such
// mark.
std::optional<std::string> with_mark(const std::string& letter, uint32_t code);

}  // namespace cleft::io
