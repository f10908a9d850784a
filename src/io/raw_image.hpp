// Voxels from files without a header.
#pragma once

#include "cleft/cleft_io.h"
#include "io/stored_image.hpp"

#include <string>

namespace cleft::io
{

// The caller's structure, whatever version of the header it knows. Throws if it makes no sense.
cleft_io_raw checked_layout(const cleft_io_raw* raw);
// `layout` is one that checked_layout() gave. Both throw Errors with the path in it.
StoredImage locate_raw_image(const std::string& path, const cleft_io_raw& layout);
Image read_raw_image(const std::string& path, const cleft_io_raw& layout);

}  // namespace cleft::io
