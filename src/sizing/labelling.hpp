// What the sizing stage needs of a volume: the material of each voxel, read row by row.
#pragma once

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/grid.hpp"
#include "mesh/tet_mesh.hpp"

#include <algorithm>
#include <functional>

namespace cleft
{

struct Labelling {
    Grid grid;
    // Writes the materials of the voxels first .. first + count - 1; may be called from many threads.
    std::function<void(int64_t first, int64_t count, Material* out)> read;
};

// The rows of voxels around a row that moves through the grid. Each row is read once while it is among the nine around
// the current one. Past the faces of the grid the outermost voxels repeat.
// Materials may be stored in one byte, in two, or follow from functions; reading a row at a time hides that at little
// cost.
class RowWindow
{
public:
    // Keeps a reference. One window per thread, since it holds rows.
    explicit RowWindow(const Labelling& labelling) : labelling_(labelling)
    {
        rows_.assign(9, Array<Material>(labelling.grid.dims[0] + 2));
        held_.fill(-1);
    }

    // Row (j, k) or the nearest row of the grid; element -1 repeats the first voxel, element dims[0] the last one.
    // Holds while rows at most one step away from it are asked for.
    const Material* row(int32_t j, int32_t k)
    {
        const Grid& grid = labelling_.grid;
        j = std::clamp(j, 0, grid.dims[1] - 1);
        k = std::clamp(k, 0, grid.dims[2] - 1);
        // Any three neighbouring numbers have different remainders, so rows around the current one never share a slot.
        const int slot = 3 * (k % 3) + j % 3;
        const int64_t number = j + int64_t{grid.dims[1]} * k;
        Material* first = rows_[slot].data() + 1;
        if (held_[slot] != number) {
            labelling_.read(number * grid.dims[0], grid.dims[0], first);
            first[-1] = first[0];
            first[grid.dims[0]] = first[grid.dims[0] - 1];
            held_[slot] = number;
        }
        return first;
    }

private:
    const Labelling& labelling_;
    Array<Array<Material>> rows_;
    FixedArray<int64_t, 9> held_{};
};

}  // namespace cleft
