// How many tetrahedra cleaving and improving make of those of a background, from what was measured.
#pragma once

#include "pipeline/crossings.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft
{

// How the points of a background lie. The more alike its tetrahedra, the more cuts are snapped away.
enum class Arrangement { lattice, octree, particles };

// For each tetrahedron of the background.
struct Pieces {
    double cleaved = 0;
    double finished = 0;  // after improving
};

Pieces pieces_of(const MeanCrossings& mean, const PipelineOptions& options, Arrangement arrangement);

// So many edges are crossed more than once that the numbers are rough.
bool is_rough(const MeanCrossings& mean);

}  // namespace cleft
