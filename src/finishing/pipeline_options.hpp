// What the stages are told.
#pragma once

#include "background/kinds.hpp"
#include "base/array.hpp"
#include "cleaving/cleave.hpp"
#include "improving/improve.hpp"
#include "mesh/bounding_box.hpp"
#include "sizing/sizing_options.hpp"
#include "volume/kept_materials.hpp"

#include <memory>

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
    // Where the affine shears: by the first, shapes are those of the world. The second goes as far that way as work on
    // shapes can follow, and is the metric of `cleave`.
    std::shared_ptr<const MetricField> of_world, towards_world;
    bool wants_lengths = false;  // the metric of `cleave` is that of the sizes, so it says how long edges are to be
    KeptMaterials kept;          // the tetrahedra of others are left out of the finished mesh
};

// These options, with lengths and shapes measured by the metric of the sizes, if there is one. It must outlive them.
PipelineOptions measured_by(const MetricField* metric, const PipelineOptions& options);

}  // namespace cleft
