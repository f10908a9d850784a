// One label map of several masks.
#pragma once

#include "io/meaning.hpp"

namespace cleft::io
{

// Mask number k becomes label k; voxels of no mask become label n behind the n masks, where there are any; a voxel of
// several masks goes to the first. The image has the geometry of the first file. Notes tell what is left to nobody,
// what is claimed twice, and which masks are empty. Throws if all of them are.
Image label_map_of_masks(const std::vector<Field>& masks, std::vector<std::string>& notes);

}  // namespace cleft::io
