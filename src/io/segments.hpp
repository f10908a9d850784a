// The segments of 3D Slicer: names of labels, and labels in layers that may overlap.
#pragma once

#include "io/image.hpp"

#include <map>
#include <string>

namespace cleft::io
{

// Is what these keys describe a segmentation?
bool has_segments(const std::map<std::string, std::string>& keys);
// Throws Error where the segments, of an image whose voxels are not read, contradict each other or are fractions.
void check_segments(const std::map<std::string, std::string>& keys, const Image& image);
// Names the labels. Layers, which are fields of the image, are made one label map, in which a later segment wins.
// Throws Error where segments and voxels contradict each other, or segments are fractions.
void apply_segments(const std::map<std::string, std::string>& keys, Image& image);

}  // namespace cleft::io
