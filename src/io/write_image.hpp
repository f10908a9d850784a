// Writes a sizing field as an image file.
#pragma once

#include "io/image.hpp"

namespace cleft::io
{

// Writes a volume of float; throws if the format cannot hold the geometry.
void write_image(const std::string& path, const Image& image);

}  // namespace cleft::io
