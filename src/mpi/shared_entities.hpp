// The points, edges and triangles of a part that other ranks have, too, by the sets of ranks that have them.
#pragma once

#include "mpi/part_view.hpp"
#include "parts/exchange.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace cleft::mpi
{

// N corners as numbers of the part, in the order of their numbers in the whole mesh.
template <size_t N>
using LocalCorners = std::vector<std::array<int32_t, N>>;

// What a set of ranks has in common, in an order that is the same on all of them.
struct SharedEntities {
    LocalCorners<1> points;
    LocalCorners<2> edges;
    LocalCorners<3> triangles;
};

// By the ranks, which ascend. Those of owned tetrahedra alone count; points of other tetrahedra are left out. All ranks
// call it.
std::map<std::vector<int32_t>, SharedEntities> shared_entities(const PartView& part, Exchange& exchange);

}  // namespace cleft::mpi
