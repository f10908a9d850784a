// The interfaces and lines of a volume and those of a mesh, and the distance of a place from either.
#pragma once

#include "base/placement.hpp"
#include "checking/nearest_tree.hpp"
#include "checking/tie_elements.hpp"
#include "volume/tie_points.hpp"

#include <optional>

namespace cleft
{

// A mesh may have two materials touch where a third lies between them in the volume. Where there is nothing of the same
// materials within some voxels, the distance is the greatest of those to the nearest interface of each material, or to
// the nearest line of each two. It is infinite if there is none of these either.

// Those of a volume. Keeps references.
class TieSurface
{
public:
    // Lengths are those of `world`.
    TieSurface(const Volume& volume, const Array<TiePoint>& points, const Placement& world);

    // Of a place in the local frame.
    double distance(const Vec3& x, const TieMaterials& of, Samples& scratch) const;

private:
    template <class IsMeant>
    int32_t nearest(const Vec3& x, double reach, const IsMeant& is_meant) const;
    double distance_near(const Vec3& x, const TiePoint& known, Samples& scratch) const;
    std::optional<Vec3> foot(const Vec3& x, const TiePoint& known, Samples& scratch) const;
    double length(const Vec3& v) const { return (world_.linear * v).norm(); }

    const Volume& volume_;
    const Array<TiePoint>& points_;
    const Placement& world_;
    const NearestTree tree_;
};

// Those of a mesh. Keeps references.
class MeshSurface
{
public:
    // `points` in the world. What is further than `reach` is no part of the same interface.
    MeshSurface(const Array<TieElement>& elements, const Array<Vec3>& points, double reach);

    // Of a place in the world.
    double distance(const Vec3& x, const TieMaterials& of) const;

private:
    const Array<TieElement>& elements_;
    const Array<Vec3>& points_;
    const double reach_;
    const NearestTree tree_;
};

// What is further off than this is no part of the same interface: in the greatest spacing of the voxels.
inline constexpr double kInterfaceReach = 3;

}  // namespace cleft
