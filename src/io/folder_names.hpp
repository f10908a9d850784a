// The names in a folder. The standard library's iterators end the process where memory runs out.
#pragma once

#include <string>
#include <vector>

namespace cleft::io
{

// Sorted, without "." and "..". Throws Error(CLEFT_ERROR_FILE) if the folder cannot be read.
std::vector<std::string> names_in(const std::string& folder);

}  // namespace cleft::io
