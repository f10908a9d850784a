// Checks what users give before a stage works on it.
#include "capi/given_mesh.hpp"

#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "base/stage.hpp"
#include "capi/mesh_frame.hpp"
#include "checking/quick_check.hpp"
#include "checking/validate.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/materials.hpp"
#include "mesh/strip.hpp"

#include <algorithm>
#include <string>

namespace cleft::capi
{

namespace
{

// How a background lies in the box of the volume.
struct Cover {
    double volume = 0;  // of its tetrahedra
    BoundingBox box;    // of its points

    explicit Cover(const TetMesh& mesh)
    {
        box.add(mesh.points);
        for (const double tets : material_volumes(mesh.points, mesh.tets, Array<Material>(mesh.tets.size(), 0), 1))
            volume += tets;
    }
};

// Tetrahedra that overlap without sharing faces show themselves where they have more volume than their box.
void check_cover(const Cover& cover, const Vec3& extent, const Run& run)
{
    // Far above the rounding of coordinates, and far below a layer of elements that is missing.
    constexpr double kSame = 1e-6;  // relative
    const auto is_outside = [&](int axis) { return cover.box.hi[axis] <= 0 || cover.box.lo[axis] >= extent[axis]; };
    if (is_outside(0) || is_outside(1) || is_outside(2))
        throw Error(CLEFT_ERROR_ARGUMENT, "the background lies outside of the volume's box");
    // Validation looks at shared faces. Two meshes in one array, as callers make them of two parts, may share none and
    // yet overlap.
    if (cover.volume > (1 + kSame) * cover.box.volume())
        throw Error(CLEFT_ERROR_INVALID_MESH,
                    "the background is not valid: its tetrahedra overlap, for their volume is " +
                        number_text(cover.volume / cover.box.volume()) + " times that of their box");
    const Vec3 margin = kSame * extent;
    // Both are allowed, for a caller may want a mesh of a part, or of more. But they are also what a wrong unit or a
    // wrong affine looks like.
    if ((cover.box.lo.array() < -margin.array()).any() || (cover.box.hi.array() > (extent + margin).array()).any())
        run.warn(
            "the background reaches out of the volume's box; outside, the labels at the sides of the box "
            "continue");
    else if (cover.volume < (1 - kSame) * extent.prod())
        run.warn("the background fills " + number_text(100 * cover.volume / extent.prod()) +
                 " % of the volume's box; the mesh fills no more");
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

namespace
{

TetMesh checked_background(const cleft_mesh& mesh, const Frame& frame, const Run& run)
{
    require_valid(mesh, "background", run);
    TetMesh out;
    to_local(mesh, frame, out.points, out.tets);
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
    check_cover(Cover(out), frame.grid.extent(), run);
    return out;
}

}  // namespace

GivenBackground given_background(const cleft_mesh& mesh, const Frame& frame, const Run& run)
{
    // Results of our own were checked when they were made. With the very points of that stage, single calls give the
    // bytes of the one call.
    if (is_as_left(mesh, MadeBy::background, frame))
        return {as_left(mesh), true};
    return {checked_background(mesh, frame, run), false};
}

ScaledSizing given_sizing(const cleft_sizing& sizing, const cleft_volume& volume)
{
    // A field belongs to voxels. One of another volume would silently give each place the size of another.
    if (sizing.frame.grid.dims != volume.frame.grid.dims)
        throw Error(CLEFT_ERROR_ARGUMENT, "the sizing field and the volume have different dims");
    return sizing.sizing;
}

}  // namespace cleft::capi
