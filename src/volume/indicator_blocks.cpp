// Marks the blocks of voxels in which one function surely wins. Most of a volume is such, and stages skip it.
#include "volume/indicator_blocks.hpp"

#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "volume/chessboard.hpp"
#include "volume/position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

constexpr int kSide = kBlock + 4;  // the voxels that the interpolation inside a block looks at
// What a byte of chessboard_distance() can hold, nearly. Deeper blocks answer false for reaches beyond 1,000 voxels.
constexpr int kGreatestDepth = 250;

// The value at a voxel, or past the grid where the line through the outermost two values leads.
// The same continuation as in indicator_field.cpp: the bound below holds for what is sampled.
double extended(const float* field, const Grid& grid, FixedArray<int32_t, 3> p, int axis = 0)
{
    if (axis == 3)
        return field[grid.index(p[0], p[1], p[2])];
    const int32_t n = grid.dims[axis];
    const int32_t end = std::clamp(p[axis], 0, n - 1);
    const int32_t past = n == 1 ? 0 : std::abs(p[axis] - end);
    p[axis] = end;
    const double last = extended(field, grid, p, axis + 1);
    if (past == 0)
        return last;
    p[axis] = end == 0 ? 1 : n - 2;
    return last + past * (last - extended(field, grid, p, axis + 1));
}

struct Cube {
    float at[kSide][kSide][kSide];

    Cube(const float* field, const Grid& grid, const FixedArray<int32_t, 3>& first)
    {
        bool inside = true;
        for (int a = 0; a < 3; ++a)
            inside = inside && first[a] >= 0 && first[a] + kSide <= grid.dims[a];
        for (int32_t z = 0; z < kSide; ++z)
            for (int32_t y = 0; y < kSide; ++y) {
                if (inside) {
                    const float* row = field + grid.index(first[0], first[1] + y, first[2] + z);
                    std::copy(row, row + kSide, at[z][y]);
                    continue;
                }
                for (int32_t x = 0; x < kSide; ++x)
                    at[z][y][x] = static_cast<float>(extended(field, grid, {first[0] + x, first[1] + y, first[2] + z}));
            }
    }

    // The greatest |second difference| along any axis.
    float curvature() const
    {
        float most = 0;
        for (int k = 0; k < kSide; ++k)
            for (int j = 0; j < kSide; ++j)
                for (int i = 1; i + 1 < kSide; ++i) {
                    most = std::max(most, std::abs(at[k][j][i - 1] - 2 * at[k][j][i] + at[k][j][i + 1]));
                    most = std::max(most, std::abs(at[k][i - 1][j] - 2 * at[k][i][j] + at[k][i + 1][j]));
                    most = std::max(most, std::abs(at[i - 1][k][j] - 2 * at[i][k][j] + at[i + 1][k][j]));
                }
        return most;
    }
};

// The best and second best of the fields at the corners of the cells that meet a block.
class Leaders
{
public:
    Leaders()
    {
        std::fill(first_, first_ + kCount, -std::numeric_limits<float>::infinity());
        std::fill(second_, second_ + kCount, -std::numeric_limits<float>::infinity());
    }
    void add(const Cube& cube, float sign, int material)
    {
        for (int z = 1, c = 0; z + 1 < kSide; ++z)
            for (int y = 1; y + 1 < kSide; ++y)
                for (int x = 1; x + 1 < kSide; ++x, ++c) {
                    const float f = sign * cube.at[z][y][x];
                    const bool better = f > first_[c];
                    second_[c] = std::max(second_[c], better ? first_[c] : f);
                    winner_[c] = better ? material : winner_[c];
                    first_[c] = std::max(first_[c], f);
                }
    }
    bool one_winner() const
    {
        return std::all_of(winner_, winner_ + kCount, [&](int w) { return w == winner_[0]; });
    }
    float least_lead() const
    {
        float least = std::numeric_limits<float>::infinity();
        for (int c = 0; c < kCount; ++c)
            least = std::min(least, first_[c] - second_[c]);
        return least;
    }

private:
    static constexpr int kCount = (kSide - 2) * (kSide - 2) * (kSide - 2);
    float first_[kCount], second_[kCount];
    int winner_[kCount] = {};
};

// Cubic convolution differs from linear interpolation by at most max |second difference| / 8 along one axis. With its
// weights' absolute sum of at most 5/4 this makes (1 + 5/4 + 25/16) / 8 < 1/2 in space; the lead of one function over
// another has at most twice the second difference of one. So a lead greater than that holds everywhere between.
bool holds_one_material(const IndicatorField& field, const FixedArray<int32_t, 3>& block)
{
    const FixedArray<int32_t, 3> first{kBlock * block[0] - 2, kBlock * block[1] - 2, kBlock * block[2] - 2};
    Leaders leaders;
    float curvature = 0;
    for (size_t k = 0; k < field.field.size(); ++k) {
        const Cube cube(field.field[k].data(), field.grid, first);
        curvature = std::max(curvature, cube.curvature());
        if (field.is_signed())
            leaders.add(cube, -1, 0);
        leaders.add(cube, 1, field.is_signed() ? 1 : static_cast<int>(k));
    }
    return leaders.one_winner() && leaders.least_lead() > curvature;
}

}  // namespace

void find_single_blocks(IndicatorField& field, const Run& run)
{
    for (int a = 0; a < 3; ++a)
        field.blocks.dims[a] = (field.grid.dims[a] + kBlock - 1) / kBlock;
    const auto [nx, ny, nz] = field.blocks.dims;
    field.depth.assign(field.blocks.size(), 0);
    Steps steps(run, {{nullptr, 9}, {nullptr, 1}});
    const Run of_blocks = steps.next();
    for (int32_t z = 0; z < nz; ++z) {
        of_blocks.report(static_cast<double>(z) / nz);
        parallel_for(run, int64_t{nx} * ny, 16, [&, nx = nx](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                const FixedArray<int32_t, 3> block{static_cast<int32_t>(i % nx), static_cast<int32_t>(i / nx), z};
                const bool one = holds_one_material(field, block);
                field.depth[field.blocks.index(block[0], block[1], block[2])] = one ? kGreatestDepth : 0;
            }
        });
    }
    // Blocks that touch share voxels, so those that are sure and touch have the same material.
    chessboard_distance(field.blocks, field.depth.data(), kGreatestDepth, steps.next());
}

bool single_material_near(const IndicatorField& field, const Vec3& x, double reach)
{
    const auto u = voxel_position(field.grid, x);
    const auto nearest = nearest_voxel(field.grid, u);
    const FixedArray<int32_t, 3> block{nearest[0] / kBlock, nearest[1] / kBlock, nearest[2] / kBlock};
    const int depth = field.depth[field.blocks.index(block[0], block[1], block[2])];
    if (depth == 0)
        return false;
    for (int a = 0; a < 3; ++a) {
        const double voxels = reach / field.grid.spacing[a];
        const int32_t low = block[a] - depth + 1, high = block[a] + depth;  // blocks low .. high - 1 are sure
        // Nothing lies past the walls of the box.
        if (low > 0 && !(u[a] - voxels >= kBlock * low - 0.5))
            return false;
        if (high < field.blocks.dims[a] && !(u[a] + voxels <= kBlock * high - 0.5))
            return false;
    }
    return true;
}

}  // namespace cleft
