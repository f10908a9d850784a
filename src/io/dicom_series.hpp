// What single files and series of DICOM share.
#pragma once

#include "io/dicom_data.hpp"
#include "io/dicom_planes.hpp"

namespace cleft::io
{

// Throws, naming what the file is, if it holds no voxels.
void check_dicom_is_image(const DicomFile& file);
// The stored values of all frames, and where each lies and how it is rescaled.
Image read_dicom_frames(const DicomFile& file, std::vector<DicomPlane>& planes);

}  // namespace cleft::io
