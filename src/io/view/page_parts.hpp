// The page as the build has it: made of the files in page/ by embed_page.cmake.
#pragma once

#include <string_view>
#include <vector>

namespace cleft::io
{

// Two marks of page.html are left for what belongs to a mesh: its title, and its data.
inline constexpr std::string_view kTitleMark = "@TITLE@";
inline constexpr std::string_view kDataMark = "@DATA@";

// Their texts one after the other are the page. Each mark is the whole of a part.
const std::vector<std::string_view>& page_parts();

}  // namespace cleft::io
