// What users give to a stage: meshes, checked whole, for the stages build on sound ones; and fields of sizes.
#pragma once

#include "base/run.hpp"
#include "capi/handles.hpp"
#include "pipeline/pipeline.hpp"

namespace cleft::capi
{

// An Error with the first fault, CLEFT_ERROR_INVALID_MESH, unless the mesh is conforming and positively oriented.
// `whose` is what it is called: "background". Points that are in no tetrahedron are no fault.
void require_valid(const cleft_mesh& mesh, const char* whose, const Run& run);

// A background in the frame of a volume.
struct GivenBackground {
    TetMesh mesh;
    bool is_ours;  // of cleft_background_create(), which repairs its own

    // A background of our own has been repaired already, so its points stay as they are.
    PipelineOptions options(PipelineOptions p) const
    {
        p.repair_angle = is_ours ? 0 : p.repair_angle;
        return p;
    }
};

// One of cleft_background_create() is taken as that stage left it. Any other is taken without the points that it does
// not use; what is not valid, overlaps, or lies outside of the volume's box is refused; where it does not fill the box,
// or reaches out of it, a warning says so.
GivenBackground given_background(const cleft_mesh& mesh, const Frame& frame, const Run& run);

// Throws CLEFT_ERROR_ARGUMENT if the field has not the dims of the volume.
void require_same_grid(const cleft_sizing& sizing, const cleft_volume& volume);
// A copy of the field, which must have the dims of the volume.
ScaledSizing given_sizing(const cleft_sizing& sizing, const cleft_volume& volume);

}  // namespace cleft::capi
