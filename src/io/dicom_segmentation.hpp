// DICOM segmentation objects: frames of segments, which overlap or leave gaps.
#pragma once

#include "io/dicom_data.hpp"
#include "io/image.hpp"

namespace cleft::io
{

bool is_dicom_segmentation(const DicomFile& file);
// A label map: the number of a segment is its label, 0 is outside; with the names of the segments.
Image read_dicom_segmentation(const DicomFile& file);

}  // namespace cleft::io
