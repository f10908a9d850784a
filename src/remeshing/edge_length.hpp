// Lengths of edges in the metric that a mesh is measured by.
#pragma once

#include "remeshing/local_mesh.hpp"

#include <array>

namespace cleft
{

// The lengths of an edge under the metrics of its ends.
std::array<double, 2> lengths_at_ends(const LocalMesh& mesh, int32_t a, int32_t b);

// The integral of the length along the edge, between whose ends the metric changes as a power.
double edge_length(const LocalMesh& mesh, int32_t a, int32_t b);
// Where half of it lies, as a share of the edge from a.
double middle_of_length(const LocalMesh& mesh, int32_t a, int32_t b);

// In the order of kEdgeCorners.
std::array<double, 6> edge_lengths(const LocalMesh& mesh, int32_t t);

}  // namespace cleft
