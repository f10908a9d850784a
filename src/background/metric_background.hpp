// The background of a sizing field that has a metric.
#pragma once

#include "background/kinds.hpp"

namespace cleft
{

// A metric that is the same everywhere and has the axes of the voxels is met by any kind: the background is that of a
// stretched box. Others are met by particles, whose mesh is adapted to the metric. Throws CLEFT_ERROR_OPTION where the
// kind cannot follow the metric.
TetMesh metric_background(const SizingField& field, const BackgroundOptions& options, const Run& run);

// Changes a mesh of any origin until it follows the metric of the field, which it must have. What is outside of the
// field's box follows the metric at the side of the box.
void adapt_to_metric(TetMesh& mesh, const SizingField& field, const Run& run);

}  // namespace cleft
