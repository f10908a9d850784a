// Where a NIfTI header places its voxels.
#pragma once

#include "io/image.hpp"
#include "io/nifti_header.hpp"

namespace cleft::io
{

// Sets the geometry of the image, whose dimensions are set; header.dim[1..3] are at least 1. It is that of the sform if
// its code is set, else of the qform if its code is set, else of the sizes of the voxels, with the middle of the box at
// the origin and the first axis to the left (as nibabel has it). Notes what is doubtful; throws for what has no
// meaning.
void set_nifti_geometry(const NiftiHeader& header, Image& image);

}  // namespace cleft::io
