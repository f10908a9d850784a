// What writers see of the part of a rank.
#pragma once

#include "cleft/cleft_parts.h"

#include <cstdint>

namespace cleft::mpi
{

// Arrays are borrowed, as in cleft_parts.h.
struct PartView {
    cleft_part_counts counts;
    const double* points;
    const int64_t* numbers;
    const int32_t* owners;
    const int32_t* tets;
    const int32_t* labels;
    const int32_t* triangles;
    const int32_t* triangle_labels;
    const int32_t* sides;  // of triangles; -1: of an interface
};

}  // namespace cleft::mpi
