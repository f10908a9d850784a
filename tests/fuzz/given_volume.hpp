// An input as a small volume, and what a mesh of it must be.
#pragma once

#include "cleft/cleft.h"

#include "fuzz/bytes.hpp"
#include "fuzz/judge.hpp"

#include <array>

namespace fuzz
{

struct Grid {
    std::array<int64_t, 3> dims{};
    std::array<double, 12> affine{};
};

Grid grid_of(Bytes& bytes);

// A volume, for as long as it lives; NULL if the library refuses it.
class Volume
{
public:
    // Takes what is left of the input for its voxels.
    Volume(const Context& context, const Options& options, const Grid& grid, Bytes& bytes);
    ~Volume();
    Volume(const Volume&) = delete;
    Volume& operator=(const Volume&) = delete;
    operator const cleft_volume*() const { return volume_; }  // for the C interface

private:
    cleft_status create_labels(const Context& context, const Options& options, const Grid& grid, Bytes& bytes);
    cleft_status create_functions(const Context& context, const Grid& grid, Bytes& bytes);

    cleft_volume* volume_ = nullptr;
};

// Looks at a mesh that was made of the volume, by a checker that shares nothing with the library's.
void judge_mesh(const Context& context, const cleft_volume* volume, const cleft_mesh* mesh, bool fills_box);

}  // namespace fuzz
