// A file with a symmetric tensor at each voxel as a plain value, and what a metric is made of it.
#pragma once

#include "cleft/cleft_io.h"
#include "io/image.hpp"

namespace cleft::io
{

// As it stands in the file. The image has a field for each number of a tensor: six of a symmetric one, all nine, or a
// mask and then six.
struct TensorImage {
    Image image;
    bool side_by_side = false;                          // the numbers of one voxel, instead of field after field
    cleft_io_tensor_order order = CLEFT_IO_ORDER_FILE;  // of the six; CLEFT_IO_ORDER_FILE: the file does not say
    // The axes of the coordinates that the tensors are in, in LPS and at right angles.
    std::array<Vector3, 3> frame{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
};

// The coordinates of RAS, in LPS.
inline constexpr std::array<Vector3, 3> kRasFrame{Vector3{-1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, 1}};

// A file of NRRD, NIfTI or VTK (legacy or .vti). Errors do not name the file. Notes have no control characters.
TensorImage read_tensor_image(const std::string& path);

// Six numbers a voxel in the order of the core, xx xy xz yy yz zz, in the world and the unit of `reading`. `order` is
// what the caller says of it. Throws an Error that names the first voxel whose tensor is not symmetric or is masked.
std::vector<double> metric_of(TensorImage tensors, cleft_io_tensor_order order, const cleft_io_reading& reading);

}  // namespace cleft::io
