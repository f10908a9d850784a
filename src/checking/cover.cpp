// Compares the bounding box of a mesh, and the volume of its tetrahedra, with a box.
#include "checking/cover.hpp"

#include "mesh/bounding_box.hpp"
#include "mesh/materials.hpp"

namespace cleft
{

Cover cover_of(const TetMesh& mesh, const Vec3& extent, const Run& run)
{
    // Far above the rounding of coordinates, and far below a layer of elements that is missing.
    constexpr double kSame = 1e-6;  // relative
    BoundingBox box;
    box.add(mesh.points);
    const double volume = material_volumes(mesh.points, mesh.tets, Array<Material>(mesh.tets.size(), 0), 1, run)[0];
    const Vec3 margin = kSame * extent;
    Cover cover;
    cover.is_outside = (box.hi.array() <= 0).any() || (box.lo.array() >= extent.array()).any();
    cover.reaches_out = (box.lo.array() < -margin.array()).any() || (box.hi.array() > (extent + margin).array()).any();
    cover.share_of_its_box = volume / box.volume();
    // Validation looks at shared faces. Two meshes in one array, as callers make them of two parts, may share none and
    // yet overlap.
    cover.overlaps = volume > (1 + kSame) * box.volume();
    cover.share_of_box = volume / extent.prod();
    cover.fills_box = volume >= (1 - kSame) * extent.prod();
    return cover;
}

}  // namespace cleft
