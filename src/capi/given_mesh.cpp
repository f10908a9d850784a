// Checks what users give before a stage works on it.
#include "capi/given_mesh.hpp"

#include "base/number_text.hpp"
#include "base/stage.hpp"
#include "capi/mesh_frame.hpp"
#include "checking/cover.hpp"
#include "checking/quick_check.hpp"
#include "checking/validate.hpp"
#include "mesh/strip.hpp"

#include <string>

namespace cleft::capi
{

namespace
{

// Refuses a background that cannot be meant, and warns of one that may not be.
void check_cover(const Cover& cover, const Run& run)
{
    if (cover.is_outside)
        throw Error(CLEFT_ERROR_ARGUMENT, "the background lies outside of the volume's box");
    if (cover.overlaps)
        throw Error(CLEFT_ERROR_INVALID_MESH,
                    "the background is not valid: its tetrahedra overlap, for their volume is " +
                        number_text(cover.share_of_its_box) + " times that of their box");
    // Both are allowed, for a caller may want a mesh of a part, or of more. But they are also what a wrong unit or a
    // wrong affine looks like.
    if (cover.reaches_out)
        run.warn(
            "the background reaches out of the volume's box; outside, the labels at the sides of the box "
            "continue");
    else if (!cover.fills_box)
        run.warn("the background fills " + number_text(100 * cover.share_of_box) +
                 " % of the volume's box; the mesh fills no more");
}

TetMesh checked_background(const cleft_mesh& mesh, const Frame& frame, const Run& run)
{
    require_valid(mesh, "background", run);
    TetMesh out;
    to_local(mesh, frame, out.points, out.tets, run);
    // Meshes from other programs keep points of curves and surfaces. A stage would take each for a vertex without
    // tetrahedra.
    drop_unused_points(out.points, out.tets);
    // Once more after the way to the local frame: it rounds, and can flatten what was sound in the world.
    const std::string fault = quick_fault(out.points, out.tets, run);
    if (!fault.empty())
        throw Error(CLEFT_ERROR_INVALID_MESH,
                    "the background is too fine for its distance from the origin: in the frame "
                    "of the volume " +
                        fault);
    check_cover(cover_of(out, frame.grid.extent(), run), run);
    return out;
}

}  // namespace

void require_valid(const cleft_mesh& mesh, const char* whose, const Run& run)
{
    // Said apart: in an empty mesh there is nothing to validate, and no stage could go on with it.
    if (mesh.mesh.tets.empty())
        throw Error(CLEFT_ERROR_ARGUMENT, std::string("the ") + whose + " has no tetrahedra");
    const Validation found = validate(mesh.mesh, false, cleft::Steps(run, {{nullptr, 0}, {nullptr, 1}}).next());
    if (!found.first_fault.empty() && found.has_more_than_unused_points())
        throw Error(CLEFT_ERROR_INVALID_MESH, std::string("the ") + whose + " is not valid: " + found.first_fault);
}

GivenBackground given_background(const cleft_mesh& mesh, const Frame& frame, const Run& run)
{
    // Results of our own were checked when they were made. With the very points of that stage, single calls give the
    // bytes of the one call.
    if (is_as_left(mesh, MadeBy::background, frame))
        return {as_left(mesh, run), true};
    return {checked_background(mesh, frame, run), false};
}

void require_same_grid(const cleft_sizing& sizing, const cleft_volume& volume)
{
    // A field belongs to voxels. One of another volume would silently give each place the size of another.
    if (sizing.frame.grid.dims != volume.frame.grid.dims)
        throw Error(CLEFT_ERROR_ARGUMENT, "the sizing field and the volume have different dims");
}

ScaledSizing given_sizing(const cleft_sizing& sizing, const cleft_volume& volume)
{
    require_same_grid(sizing, volume);
    return sizing.sizing;
}

}  // namespace cleft::capi
