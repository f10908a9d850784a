// What single files and series of DICOM share.
#pragma once

#include "io/dicom_data.hpp"
#include "io/dicom_planes.hpp"

namespace cleft::io
{

// Throws, naming what the file is, if it holds no voxels.
// Error(CLEFT_ERROR_UNSUPPORTED) for known classes without voxels, Error(CLEFT_ERROR_FORMAT) for
// others.
void check_dicom_is_image(const DicomFile& file);
// The stored values of all frames, and where each lies and how it is rescaled.
// `planes` receives one entry a frame. Doubts about the file are in the notes of the image, and the
// values are not rescaled yet.
Image read_dicom_frames(const DicomFile& file, std::vector<DicomPlane>& planes);

}  // namespace cleft::io
