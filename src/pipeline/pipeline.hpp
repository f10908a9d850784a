// The stages one after the other.
#pragma once

#include "finishing/improve_and_fit.hpp"
#include "pipeline/scaled_sizing.hpp"

namespace cleft
{

// The sizing field of the volume. max_tets limits the tetrahedra of the background that the options name.
SizingField sizes_of(const Volume& volume, const PipelineOptions& options, const Run& run);

// The stage of sizing. With options.tets the field is scaled until its mesh has that number, which it finds by making
// meshes.
ScaledSizing make_sizing(const Volume& volume, const PipelineOptions& options, const Run& run);
// The same for a field that is given: as it is, or combined with the computed one by minimum.
ScaledSizing make_sizing(const Volume& volume, SizingField given, bool is_combined, PipelineOptions options,
                         const Run& run);

// Of the kind that the options name, in the local frame. Throws CLEFT_ERROR_TOO_LARGE where it would have too many
// elements.
TetMesh make_background(const ScaledSizing& sizing, const PipelineOptions& options, const Run& run);

// The stage of cleaving. Poor tetrahedra of the background are repaired first, as the options say.
LabelledMesh repair_and_cleave(const Volume& volume, TetMesh background, const PipelineOptions& options,
                               const Run& run);

// Cleaving, improving and fitting, without the final checks and the ordering.
LabelledMesh cleave_improve_and_fit(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                    const Run& run);

// The last stage: angles and volumes of a cleaved mesh are improved, what was missed is reported (with `strict`,
// refused), and the mesh is ordered.
LabelledMesh improve_and_finish(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options,
                                const Run& run);

// All stages. These three leave out the tetrahedra of materials that are not kept.
LabelledMesh mesh_from_volume(const Volume& volume, const PipelineOptions& options, const Run& run);

// From the sizing field on; the field is given away so that its memory is free when cleaving begins.
LabelledMesh mesh_from_sizing(const Volume& volume, ScaledSizing sizing, const PipelineOptions& options,
                              const Run& run);

// From a user-supplied background on. It is repaired as the options say, and adapted to the metric of the field, if
// there is one.
LabelledMesh mesh_from_background(const Volume& volume, TetMesh background, const SizingField* adapted_to,
                                  const PipelineOptions& options, const Run& run);

}  // namespace cleft
