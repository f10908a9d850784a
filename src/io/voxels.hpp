// Voxels of files turned into what the core takes: labels of five types, or fields of float or double.
#pragma once

#include "cleft/cleft_io.h"
#include "io/image.hpp"

namespace cleft::io
{

// The affine map from voxel indices to the wanted world, with a scale that is not 0. Throws if it would flatten the
// volume.
std::array<double, 12> affine_of(const Image& image, const cleft_io_reading& reading);
// The same map taken apart again, back in ITK's world.
void set_geometry(std::array<double, 12> affine, cleft_io_world world, Image& image);

// Are all voxels whole numbers, none of them negative?
bool looks_like_labels(const Image& image);
// The type of the core's that the component corresponds to. Throws for those that have none.
cleft_type type_of(Component component);
// In place where the new type is not wider. Throws if a voxel is not whole or does not fit.
void make_labels(Image& image);
void make_floating(Image& image);
// From float to double.
void widen(Image& image);
// Multiplies voxels of float or double.
void scale_values(double factor, Image& image);

}  // namespace cleft::io
