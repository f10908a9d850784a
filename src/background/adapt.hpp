// Adapts a background to a metric: edges of length one, and tetrahedra that are regular when the metric measures them.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/metric_field.hpp"

namespace cleft
{

// Of a mesh whose edges are about as long as the greatest sizes of the metric. The hull stays exactly what it is for
// planes across an axis; points of other parts of the hull stay where they are. The same bytes for any number of
// threads. Notes background.adapt.{tets, ...} as repair() does, with angles in the metric.
//   `expected`: tetrahedra that the metric asks for. Splits end at twice as many.
void adapt(TetMesh& mesh, const MetricField& metric, double expected, const Run& run);

}  // namespace cleft
