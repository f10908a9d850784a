// The pixels of a DICOM file that are compressed.
#pragma once

#include "io/image.hpp"

namespace cleft::io
{

// The stored values of an image of known type and dims that are compressed by JPEG and its kin. GDCM reads them, in a
// process of its own: it ends the process that uses it when a file is damaged.
// Throws Error(CLEFT_ERROR_FORMAT) for what GDCM cannot decode within a minute, and std::bad_alloc
// where its process ran out of memory.
void read_compressed_pixels(const std::string& path, Image& image);

}  // namespace cleft::io
