// NIfTI-1 of one file, for fields of float.
#pragma once

#include "io/image.hpp"

#include <string>

namespace cleft::io
{

// Compressed where the name ends in .nii.gz. The place is written as an sform of code 1, and as a qform of code 1 where
// the grid is not sheared. Throws Error(CLEFT_ERROR_UNSUPPORTED) for more voxels along an axis than NIfTI-1 can tell.
void write_nifti(const std::string& path, const Image& image);

}  // namespace cleft::io
