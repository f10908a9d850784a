// Whatever path the user gives: a file, a folder, a pattern of slices.
#pragma once

#include "io/image.hpp"

#include <string>

namespace cleft::io
{

// Errors name the path.
// Throws Error: FILE where there is no such file, FORMAT or UNSUPPORTED for what it holds.
Image read_image_or_series(const std::string& path);

}  // namespace cleft::io
