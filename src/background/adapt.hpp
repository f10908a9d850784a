// Adapts a background to a metric: edges of length one, and tetrahedra that are regular when the metric measures them.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/metric_field.hpp"

namespace cleft
{

// How long the edges of a mesh are when its adaptation begins: about as long as the greatest sizes of the metric, or
// not known, so that lengths are made before directions.
enum class MadeOf { greatest_sizes, any_sizes };

// The hull stays exactly what it is for planes across an axis; points of other parts of the hull stay where they are.
// The same bytes for any number of threads. Notes background.adapt.{tets, ...} as repair() does, with angles in the
// metric.
//   `expected`: tetrahedra that the metric asks for. Splits end at twice as many.
void adapt(TetMesh& mesh, const MetricField& metric, double expected, MadeOf made_of, const Run& run);

}  // namespace cleft
