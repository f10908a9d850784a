// Where the blocks of a volume are. They are slabs across its last axis, all of the same thickness.
#pragma once

#include "base/vec.hpp"
#include "mesh/bounding_box.hpp"
#include "volume/volume.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

namespace cleft
{

struct BlockLayout {
    Grid grid;  // of the whole volume
    int32_t count = 1;

    // Blocks of so many planes of voxels or a little more; one block for 0 planes.
    static BlockLayout of(const Grid& grid, int32_t planes)
    {
        return {grid, planes > 0 ? std::max(1, grid.dims[2] / planes) : 1};
    }

    BoundingBox box() const { return {Vec3::Zero(), grid.extent()}; }
    double thickness() const { return grid.extent()[2] / count; }
    // Where a block begins. Tetrahedra are in the block that has their middle.
    double start(int32_t block) const { return thickness() * block; }
    int32_t block_at(double z) const
    {
        return std::clamp(static_cast<int32_t>(std::floor(z / thickness())), 0, count - 1);
    }
    // Its share of the planes of voxels: each belongs to one block.
    Planes planes(int32_t block) const
    {
        const auto first = [&](int32_t b) { return static_cast<int32_t>(int64_t{grid.dims[2]} * b / count); };
        return {first(block), first(block + 1) - first(block)};
    }
};

// A volume that is had in parts: whole, or read as it is asked for, in any order.
struct VolumeParts {
    Grid grid;  // of the whole
    // At least these planes can be sampled.
    std::function<std::shared_ptr<const Volume>(Planes wanted)> planes;

    // All that work on tetrahedra looks at.
    std::shared_ptr<const Volume> around(const Array<Vec3>& points, const Array<Tet>& tets) const;
};

// The middle of a tetrahedron along the last axis.
inline double middle_of(const Array<Vec3>& points, const Tet& tet)
{
    return 0.25 * (points[tet[0]][2] + points[tet[1]][2] + points[tet[2]][2] + points[tet[3]][2]);
}

}  // namespace cleft
