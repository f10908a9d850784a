// The sizing field of anything whose voxels have materials: compute_sizing without the Volume.
#pragma once

#include "base/array.hpp"
#include "sizing/labelling.hpp"
#include "sizing/sizing_field.hpp"
#include "sizing/sizing_options.hpp"

#include <string>

namespace cleft
{

// Throws unless a size that is given is 0, which stands for none, or within what a field may have. `name` is what it is
// called in the sentence.
void check_size(const std::string& name, double value);

// Throws if the greatest wanted size is less than the least.
void check_size_range(const SizingOptions& options);

// What size_max 0 stands for.
double default_size_max(const Grid& grid);

// A greatest size at a voxel.
struct SizeLimit {
    int64_t voxel;
    float size;
};

// `limits` come on top of what the materials ask for; size_min bounds them, as it does features.
SizingField compute_sizing(const Labelling& labelling, const SizingOptions& options, const Run& run,
                           const Array<SizeLimit>& limits = {});

}  // namespace cleft
