// Writes a sizing field or a metric as an image file.
#pragma once

#include "io/image.hpp"

namespace cleft::io
{

// Writes a volume of float; throws if the format cannot hold the geometry.
void write_image(const std::string& path, const Image& image);
// The same of a volume with six numbers at each voxel, side by side: xx xy xz yy yz zz of a symmetric tensor.
void write_tensors(const std::string& path, const Image& image);

}  // namespace cleft::io
