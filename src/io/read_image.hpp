// Reads an image file of any format.
#pragma once

#include "io/image.hpp"

namespace cleft::io
{

// One file, in whatever format its first bytes show. Errors do not name the file.
// Notes and names in it have no control characters, so they can go to a terminal.
Image read_image(const std::string& path);

}  // namespace cleft::io
