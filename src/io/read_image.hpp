// Reads an image file of any format.
#pragma once

#include "io/stored_image.hpp"

namespace cleft::io
{

// One file, in whatever format its first bytes show. Errors do not name the file.
// Notes and names in it have no control characters, so they can go to a terminal.
Image read_image(const std::string& path);
// Where the voxels of such a file are, if they may be read by parts; else an Error.
StoredImage locate_image(const std::string& path);

}  // namespace cleft::io
