// What a cleaved mesh goes through until it is told of: the same for a whole one and for a part.
#pragma once

#include "finishing/pipeline_options.hpp"
#include "volume/volume.hpp"

#include <functional>

namespace cleft
{

// Gives a cleaved mesh, the same one whenever it is called: improving may need it again, and need not hold it.
using Cleaved = std::function<LabelledMesh(const Run& run)>;

// Improving and fitting of a cleaved mesh, without the final checks and the ordering.
LabelledMesh improve_and_fit(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options,
                             const Run& run);

}  // namespace cleft
