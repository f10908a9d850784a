// A random small volume with random options, and what is done with it: the same for the same seed on every machine.
#pragma once

#include "cleft/cleft.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace storm
{

// How the mesh is made.
enum class Way {
    whole,       // one call
    sizing,      // one call with a user-supplied sizing field
    background,  // one call with a user-supplied background, poor and tampered with at times
    metric,      // a user-supplied metric, in one call or several
    stages,      // background, cleaving, improving and stripping, a call each
    parts,       // one call, and then again by several ranks
};

struct Case {
    std::array<int64_t, 3> dims{};
    std::array<double, 12> affine{};
    // A label map, or indicator functions if there are any.
    cleft_type type = CLEFT_TYPE_INT32;
    std::vector<int32_t> labels;
    std::vector<std::vector<float>> functions;
    Way way = Way::whole;
    std::vector<double> sizes;  // a user-supplied field, for Way::sizing
    // Six numbers a voxel, or six for all, for Way::metric.
    std::vector<double> tensors;
    bool is_staged = false, is_combined = false;
    double constant_size = 0;  // of the background, for Way::stages and Way::background
    int64_t cancel_at = 0;     // the call of the progress callback that asks to cancel; 0: none
    int32_t threads = 1;
    // For Way::parts: how many there are, the one that cancels, and its reading of voxels that fails; 0: none.
    int32_t ranks = 1, upset_rank = 0;
    int64_t fail_at = 0;
    bool has_ghosts = false, has_scratch = false;
    // Options by name.
    std::vector<std::pair<std::string, std::string>> options;
    std::vector<std::pair<int32_t, double>> label_sizes;
    std::vector<int32_t> strip, only;
    std::string text;  // what it is, in a line

    int64_t voxel_count() const { return dims[0] * dims[1] * dims[2]; }
};

Case random_case(uint64_t seed);

// A label map that is meshed block by block, in one process and on several ranks.
Case random_parts_case(uint64_t seed);

}  // namespace storm
