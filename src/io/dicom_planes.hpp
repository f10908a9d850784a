// Where the slices and frames of DICOM files lie.
#pragma once

#include "io/dicom_data.hpp"
#include "io/image.hpp"

namespace cleft::io
{

struct DicomPlane {
    bool placed = false;  // are position and orientation known?
    Vector3 position{0, 0, 0};
    Vector3 along_row{1, 0, 0};
    Vector3 along_column{0, 1, 0};
    bool sized = false;         // is the size of a pixel known?
    bool at_detector = false;   // ... but where the rays arrive alone
    double column_spacing = 1;  // along a row
    double row_spacing = 1;     // along a column
    double between_slices = 0;  // as stated; 0: not stated
    double thickness = 0;       // of a slice, as stated; 0: not stated
    double slope = 1;           // of the values
    double intercept = 0;

    double slice_spacing() const { return between_slices > 0 ? between_slices : thickness; }
};

// One for each frame, of what the file says for all frames and for each.
// Throws Error(CLEFT_ERROR_FORMAT) where directions lie on one line, or the groups are not one for
// each frame.
std::vector<DicomPlane> planes_of(const DicomFile& file, int64_t frames);

// Even slots along the third axis, and which of them each plane takes.
struct DicomStack {
    Image geometry;  // dims, directions, spacing and origin, and notes; no voxels
    std::vector<int64_t> slots;
};

// Planes that all lie at places of their own, without a gap. Throws if they do not, or differ in orientation or
// spacing; `who` names plane number i.
DicomStack stack_of(const std::vector<DicomPlane>& planes, const std::vector<std::string>& who);
// Planes of which several may lie at one place, and places may be empty.
// Throws where the places fit no even grid. Frames of a segmentation may be missing where a segment
// is empty.
DicomStack loose_stack_of(const std::vector<DicomPlane>& planes, const std::vector<std::string>& who);

// Sets directions and spacing, and the place of the first voxel.
void set_plane(const DicomPlane& plane, Image& image);

// Gives the volume the directions, spacing and origin of the stack.
void set_place(const DicomStack& stack, Image& volume);

// Copies frame i to its slot of the volume.
void copy_to_slots(const DicomStack& stack, const Image& frames, Image& volume);

// Moves slice i of a volume to slot i of the stack, and gives the volume the place of the stack.
void put_in_slots(const DicomStack& stack, Image& volume);

// Applies slope and intercept of each plane to its slice of the image, slice i being plane i. Nothing happens if all
// are 1 and 0.
void rescale(const std::vector<DicomPlane>& planes, Image& image);

}  // namespace cleft::io
