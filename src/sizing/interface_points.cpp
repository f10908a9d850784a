// The normal is the gradient of the share of the voxel's own material in the box of 27 voxels around it; the point is
// the nearest to the centre on the planes with that normal through the middles of the voxel's faces at the interface.
// Both follow from the integer gradient, 19 values an axis, and from which axes have such a face: 54,872 codes.
#include "sizing/interface_points.hpp"

#include "base/touched_array.hpp"

#include <cmath>
#include <cstdlib>

namespace cleft
{
namespace
{

// A table of all codes takes 1.3 MB. Points and normals of all voxels would take 24 bytes for each.
constexpr int kSteps = 19;  // the gradient along an axis is -9 .. 9: nine voxels on either side
constexpr size_t kCodeCount = size_t{8} * kSteps * kSteps * kSteps;

struct Code {
    FixedArray<int, 3> gradient;  // of the own share
    int faces;                    // bit a: the face along axis a on the side of the normal is at an interface

    uint16_t pack() const
    {
        CLEFT_ASSERT(faces > 0 && faces < 8);
        return static_cast<uint16_t>((((gradient[2] + 9) * kSteps + gradient[1] + 9) * kSteps + gradient[0] + 9) * 8 +
                                     faces);
    }
    static Code unpack(size_t packed)
    {
        const auto g = static_cast<int>(packed / 8);
        return {{g % kSteps - 9, g / kSteps % kSteps - 9, g / (kSteps * kSteps) - 9}, static_cast<int>(packed % 8)};
    }
};

InterfacePoint decode(const Code& code, const Vec3& spacing)
{
    Vec3 normal;
    for (int a = 0; a < 3; ++a)
        // Counts of voxels become a gradient in world units by the spacing; the share falls outwards, so the normal is
        // its opposite.
        normal[a] = -code.gradient[a] / spacing[a];
    normal.normalize();
    double distance = INFINITY;
    for (int a = 0; a < 3; ++a)
        if (code.faces >> a & 1)
            // The nearest of the planes: the point stays within the voxel, whatever the normal.
            distance = std::min(distance, 0.5 * spacing[a] * std::abs(normal[a]));
    InterfacePoint point;
    for (int a = 0; a < 3; ++a) {
        point.normal[a] = static_cast<float>(normal[a]);
        point.offset[a] = static_cast<float>(distance * normal[a]);
    }
    return point;
}

Array<InterfacePoint> decode_all(const Vec3& spacing)
{
    Array<InterfacePoint> table(kCodeCount);
    for (size_t packed = 0; packed < kCodeCount; ++packed) {
        const Code code = Code::unpack(packed);
        if (code.faces != 0 && code.gradient != FixedArray<int, 3>{0, 0, 0})
            table[packed] = decode(code, spacing);
    }
    return table;
}

// The rows around row (j, k): rows[dk + 1][dj + 1].
using RowsAround = FixedArray<FixedArray<const Material*, 3>, 3>;

RowsAround rows_around(RowWindow& window, int32_t j, int32_t k)
{
    RowsAround rows;
    for (int dk = 0; dk < 3; ++dk)
        for (int dj = 0; dj < 3; ++dj)
            rows[dk][dj] = window.row(j + dj - 1, k + dk - 1);
    return rows;
}

FixedArray<int, 3> own_share_gradient(const RowsAround& rows, int32_t i)
{
    const Material own = rows[1][1][i];
    FixedArray<int, 3> gradient{0, 0, 0};
    for (int dk = -1; dk <= 1; ++dk)
        for (int dj = -1; dj <= 1; ++dj) {
            const Material* row = rows[dk + 1][dj + 1] + i;
            const int before = row[-1] == own;
            const int after = row[1] == own;
            const int sum = before + (row[0] == own) + after;
            gradient[0] += after - before;
            gradient[1] += dj * sum;
            gradient[2] += dk * sum;
        }
    return gradient;
}

// As InterfacePoints::sides.
int other_sides(const RowsAround& rows, int32_t i)
{
    const Material own = rows[1][1][i];
    return (rows[1][1][i - 1] != own) | (rows[1][1][i + 1] != own) << 1 | (rows[1][0][i] != own) << 2 |
           (rows[1][2][i] != own) << 3 | (rows[0][1][i] != own) << 4 | (rows[2][1][i] != own) << 5;
}

Code code_of(const RowsAround& rows, int32_t i, int sides)
{
    CLEFT_ASSERT(sides != 0);
    Code code{own_share_gradient(rows, i), 0};
    for (int a = 0; a < 3; ++a) {
        const int g = code.gradient[a];
        if ((g > 0 && sides >> (2 * a) & 1) || (g < 0 && sides >> (2 * a + 1) & 1))
            code.faces |= 1 << a;
    }
    if (code.faces != 0)
        return code;
    // As in the middle of a sheet: no side of an interface prevails. Take the first.
    int side = 0;
    while (!(sides >> side & 1))
        ++side;
    code.gradient = {0, 0, 0};
    code.gradient[side / 2] = side % 2 == 0 ? 1 : -1;
    code.faces = 1 << (side / 2);
    return code;
}

}  // namespace

InterfacePoints::InterfacePoints(const Labelling& labelling, const Run& run)
    : codes_(large_array<uint16_t>(run, labelling.grid.size())),
      sides_(large_array<uint8_t>(run, labelling.grid.size())),
      table_(decode_all(labelling.grid.spacing))
{
    const Grid& grid = labelling.grid;
    const int64_t grain = rows_per_chunk(grid);
    Array<int64_t> found(chunk_count(row_count(grid), grain));
    parallel_with_progress(run, row_count(grid), grain, [&](int64_t chunk, int64_t begin, int64_t end) {
        RowWindow window(labelling);
        for (int64_t row = begin; row < end; ++row) {
            const RowsAround rows =
                rows_around(window, static_cast<int32_t>(row % grid.dims[1]), static_cast<int32_t>(row / grid.dims[1]));
            for (int32_t i = 0; i < grid.dims[0]; ++i) {
                const int sides = other_sides(rows, i);
                if (sides == 0)
                    continue;
                const int64_t voxel = row * grid.dims[0] + i;
                codes_[voxel] = code_of(rows, i, sides).pack();
                sides_[voxel] = static_cast<uint8_t>(sides);
                ++found[chunk];
            }
        }
    });
    for (const int64_t n : found)
        count_ += n;
}

}  // namespace cleft
