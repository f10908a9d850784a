// How well a mesh meets a metric: lengths of edges, shapes and angles as the metric measures them.
#pragma once

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/metric_field.hpp"

namespace cleft
{

// The measures of the Unstructured Grid Adaptation Working Group, whose wanted length of an edge is 1, and angles.
struct MetricQuality {
    int64_t edges = 0;
    int64_t edges_in_range = 0;  // of a length from 1 / sqrt(2) to sqrt(2)
    double edge_least = 0, edge_01 = 0, edge_median = 0, edge_99 = 0, edge_greatest = 0;
    // 1 is a regular tetrahedron, 0 a flat one; an inverted one is negative.
    double mean_ratio_least = 0, mean_ratio_01 = 0, mean_ratio_median = 0;
    // Degrees, over all angles.
    double min_dihedral = 0, max_dihedral = 0;
    // All angles, bins of 5 degrees.
    FixedArray<int64_t, 36> dihedral_histogram{};
};

// The mesh is in the frame of the field. All zero for no tetrahedra. Corners that are not points, or repeated, are an
// Error (CLEFT_ERROR_INVALID_MESH).
MetricQuality measure_by_metric(const TetMesh& mesh, const MetricField& metric, const Run& run);

}  // namespace cleft
