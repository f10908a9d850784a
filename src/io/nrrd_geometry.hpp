// Which axes of an NRRD file are of space, and where its voxels lie.
#pragma once

#include "io/image.hpp"
#include "io/nrrd_header.hpp"

#include <optional>

namespace cleft::io
{

struct NrrdAxes {
    std::vector<size_t> space;    // two or three, in the order of the file
    std::optional<size_t> other;  // the axis along which volumes or layers are counted: the first or the last
};

// Throws if the axes are none of a volume, or of several.
NrrdAxes nrrd_axes(const NrrdHeader& header);
// The same of a file with a tensor at each voxel, which has three axes of space; `other` is that of its numbers.
NrrdAxes nrrd_tensor_axes(const NrrdHeader& header);
// The axes that vectors and tensors in the file have their coordinates in, in LPS. Those of its space if it says
// nothing else.
std::array<Vector3, 3> nrrd_measurement_frame(const NrrdHeader& header);
// Sets directions, spacing and origin.
// `axes` are those of nrrd_axes(). Throws where fields contradict each other; doubts go to
// image.notes.
void set_nrrd_geometry(const NrrdHeader& header, const NrrdAxes& axes, Image& image);

}  // namespace cleft::io
