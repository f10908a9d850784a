// DICOM segmentation objects: frames of segments, which overlap or leave gaps.
#pragma once

#include "io/dicom_data.hpp"
#include "io/image.hpp"

namespace cleft::io
{

// By the SOP class, whatever the folder or the modality says.
bool is_dicom_segmentation(const DicomFile& file);
// A label map: the number of a segment is its label, 0 is outside; with the names of the segments.
// Notes tell of overlaps and of fractions. Throws Error(CLEFT_ERROR_FORMAT) where frames and
// segments do not fit each other.
Image read_dicom_segmentation(const DicomFile& file);

}  // namespace cleft::io
