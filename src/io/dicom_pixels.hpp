// The pixels of a DICOM file as they are stored.
#pragma once

#include "io/dicom_data.hpp"
#include "io/image.hpp"

namespace cleft::io
{

struct DicomPixelFormat {
    int64_t columns = 0;
    int64_t rows = 0;
    int64_t frames = 1;
    int64_t bits_allocated = 0;
    int64_t bits_stored = 0;
    int64_t high_bit = 0;  // the highest of those that are stored
    bool is_signed = false;

    int64_t frame_size() const { return columns * rows; }
};

// Throws for what is no image, and for colours.
// The numbers fit each other: rows, columns and frames are at least 1, and 1 <= bits_stored <=
// high_bit + 1 <= bits_allocated.
DicomPixelFormat pixel_format_of(const DicomFile& file);

// All frames, one behind the other along z; numbers of one bit become bytes. The file's geometry is not in it.
// Throws if the pixels are damaged.
Image pixels_of(const DicomFile& file, const DicomPixelFormat& format);

}  // namespace cleft::io
