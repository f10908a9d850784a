// Voxels of files turned into what the core takes: labels of five types, or fields of float or double.
#pragma once

#include "cleft/cleft_io.h"
#include "io/image.hpp"

namespace cleft::io
{

// The affine map from voxel indices to the wanted world, with a scale that is not 0. Throws if it would flatten the
// volume.
std::array<double, 12> affine_of(const Image& image, const cleft_io_reading& reading);
// What is to be reported where the caller's spacing replaces the file's: the origin does not follow.
std::vector<std::string> notes_on_spacing(const Image& image, const cleft_io_reading& reading);
// The same map taken apart again, back in ITK's world.
void set_geometry(std::array<double, 12> affine, cleft_io_world world, Image& image);

// The type of the core's that the component corresponds to. Throws for those that have none.
cleft_type type_of(Component component);
// The type that make_labels() gives.
Component label_component(Component component);
// In place where the new type is not wider. Fractions are rounded to the nearest; throws if a label does not fit.
void make_labels(Image& image);
// Whole numbers become float. float and double stay as they are.
void make_floating(Image& image);
// From float to double.
void widen(Image& image);
// Multiplies voxels of float or double.
void scale_values(double factor, Image& image);

}  // namespace cleft::io
