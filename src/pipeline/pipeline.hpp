// The stages one after the other.
#pragma once

#include "background/kinds.hpp"
#include "base/array.hpp"
#include "cleaving/cleave.hpp"
#include "improving/improve.hpp"
#include "mesh/bounding_box.hpp"
#include "pipeline/scaled_sizing.hpp"
#include "sizing/sizing_options.hpp"
#include "volume/kept_materials.hpp"
#include "volume/volume.hpp"

#include <functional>

namespace cleft
{

// A part of the volume that stages work on, which was cut out of a larger mesh.
struct Region {
    BoundingBox box;        // of the whole; hull triangles in none of its sides are held
    Array<double> volumes;  // that each material is to have in the part
    bool is_cut_open;       // work on the larger mesh comes later where the part was cut out
};

struct PipelineOptions {
    SizingOptions sizing;
    BackgroundOptions background;
    CleaveOptions cleave;
    ImproveOptions improve;
    double repair_angle = 30;  // degrees; 0: a user's background is cleaved as it is
    int64_t tets = 0;          // wanted number of tetrahedra of the kept materials; 0: as the sizing field says
    double max_tets = 0;       // bounds all tetrahedra where `tets` counts some of them; 0: no limit
    bool strict = false;
    bool asks_surface_error = false;  // the user does, so that a warning says where it has no effect
    int32_t block = 0;                // planes of voxels across a block, see mesh_blocks.hpp; 0: no blocks
    const Region* region = nullptr;   // null: all of the volume
    KeptMaterials kept;               // the tetrahedra of others are left out of the finished mesh
};

// These options, with lengths and shapes measured by the metric, if there is one. It must outlive them.
PipelineOptions measured_by(const MetricField* metric, const PipelineOptions& options);

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

// Gives a cleaved mesh, the same one whenever it is called: improving may need it again, and need not hold it.
using Cleaved = std::function<LabelledMesh(const Run& run)>;

// Improving and fitting of a cleaved mesh, without the final checks and the ordering.
LabelledMesh improve_and_fit(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options,
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
