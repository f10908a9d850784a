// Finds where h has its greatest value all around, and fills these places with one body-centred cubic lattice.
#include "background/bcc_patches.hpp"

#include "base/parallel.hpp"

#include <cmath>

namespace cleft
{

namespace
{

using Index = FixedArray<int32_t, 3>;

int64_t flat(const Index& i, const Index& dims)
{
    CLEFT_ASSERT(i[0] < dims[0] && i[1] < dims[1] && i[2] < dims[2]);
    return i[0] + int64_t{dims[0]} * (i[1] + int64_t{dims[1]} * i[2]);
}

Index corner_dims(const Index& cells) { return {cells[0] + 1, cells[1] + 1, cells[2] + 1}; }

// The lattice point i + shift; the last one of an axis lies on the wall exactly.
Vec3 position(const BccPatches& lattice, const Index& i, double shift)
{
    Vec3 x;
    for (int a = 0; a < 3; ++a)
        x[a] = i[a] == lattice.cells[a] ? lattice.extent[a] : (i[a] + shift) * lattice.cell[a];
    return x;
}

// The nearest point of one of the two sublattices, and its squared distance in cells.
Index nearest(const BccPatches& lattice, const Vec3& x, double shift, double& distance)
{
    const int32_t beyond = shift > 0 ? 1 : 0;
    Index i;
    distance = 0;
    for (int a = 0; a < 3; ++a) {
        const double u = x[a] / lattice.cell[a] - shift;
        i[a] = std::clamp(static_cast<int32_t>(std::lround(u)), 0, lattice.cells[a] - beyond);
        distance += (u - i[a]) * (u - i[a]);
    }
    return i;
}

// Whether h is constant at x and a little more than half a cell away from it along each axis.
// A point beside a gradient must not be in the lattice: half a cell away it would meet particles of other distances.
bool is_constant_near(const SizeSampler& size, const Vec3& x, double constant, const Vec3& cell)
{
    const auto is_constant = [&](const Vec3& p) { return size(p) >= 0.999 * constant; };
    if (!is_constant(x))
        return false;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = 0.6 * cell[axis] * Vec3::Unit(axis);
        if (!is_constant(x - step) || !is_constant(x + step))
            return false;
    }
    return true;
}

void mark_used(Array<uint8_t>& used, const Index& dims, const BccPatches& lattice, double shift,
               const SizeSampler& size, double constant, const Run& run)
{
    used.assign(int64_t{dims[0]} * dims[1] * dims[2], 0);
    parallel_for(run, int64_t{dims[1]} * dims[2], 64, [&](int64_t begin, int64_t end) {
        for (int64_t row = begin; row < end; ++row) {
            Index i{0, static_cast<int32_t>(row % dims[1]), static_cast<int32_t>(row / dims[1])};
            for (; i[0] < dims[0]; ++i[0])
                used[flat(i, dims)] = is_constant_near(size, position(lattice, i, shift), constant, lattice.cell);
        }
    });
}

template <class Visit>
void for_each_used(const Array<uint8_t>& used, const Index& dims, const Visit& visit)
{
    Index i;
    for (i[2] = 0; i[2] < dims[2]; ++i[2])
        for (i[1] = 0; i[1] < dims[1]; ++i[1])
            for (i[0] = 0; i[0] < dims[0]; ++i[0])
                if (used[flat(i, dims)])
                    visit(i);
}

}  // namespace

bool BccPatches::fill_the_box() const
{
    const auto all = [](const Array<uint8_t>& used) { return std::find(used.begin(), used.end(), 0) == used.end(); };
    return !empty() && all(corner_used) && all(centre_used);
}

bool BccPatches::owns(const Vec3& x, Walls walls) const
{
    if (empty())
        return false;
    double to_corner, to_centre;
    const Index corner = nearest(*this, x, 0, to_corner), centre = nearest(*this, x, 0.5, to_centre);
    if (walls != 0 || to_corner <= to_centre)
        return corner_used[flat(corner, corner_dims(cells))];
    return centre_used[flat(centre, cells)];
}

void BccPatches::add_particles(ParticleSet& out) const
{
    if (empty())
        return;
    for_each_used(corner_used, corner_dims(cells), [&](const Index& i) {
        Walls walls = 0;
        for (int a = 0; a < 3; ++a)
            if (i[a] == 0 || i[a] == cells[a])
                walls = static_cast<Walls>(walls | 1 << a);
        if (wall_count(walls) < 3)
            out.add(position(*this, i, 0), walls);
    });
    for_each_used(centre_used, cells, [&](const Index& i) { out.add(position(*this, i, 0.5), 0); });
}

namespace
{

// Cells of the lattice along each axis: of the whole numbers next to length / wanted, those whose product is nearest to
// the number of cells wanted, so that a lattice fitted to the box does not change the number of particles by more than
// it must. All zero if some side would have to be stretched by more than a tenth.
Index cells_between_walls(const Vec3& extent, double wanted)
{
    // A lattice stretched by a tenth has angles a few degrees worse. More would cost what the lattice is there for.
    constexpr double kStretch = 0.1;
    const Vec3 exact = extent / wanted;
    Index best{};
    double least_misfit = 1e300;
    for (int choice = 0; choice < 8; ++choice) {
        Index cells{};
        double misfit = 0;
        bool fits = true;
        for (int a = 0; a < 3; ++a) {
            const double count = std::max(1.0, std::floor(exact[a]) + (choice >> a & 1));
            const double stretch = exact[a] / count;
            fits = fits && std::abs(stretch - 1) <= kStretch;
            misfit += std::log(stretch);
            cells[a] = static_cast<int32_t>(std::min(count, 1e9));
        }
        // Choices of equal misfit, as a cube has them, must not be decided by rounding: the first one wins.
        if (fits && std::abs(misfit) < least_misfit - 1e-12) {
            least_misfit = std::abs(misfit);
            best = cells;
        }
    }
    return best;
}

// A cell holds two points, so this side gives the density that particles have elsewhere.
double cell_side(double size) { return size * std::cbrt(2 / kParticleDensity[3]); }

}  // namespace

double cells_of_constant_size(const Grid& grid, double size)
{
    double count = 1;
    for (const int32_t cells : cells_between_walls(grid.extent(), cell_side(size)))
        count *= cells;
    return count;
}

BccPatches constant_size_patches(const SizingField& field, const SizeSampler& size, const Run& run)
{
    const double greatest = field.range().greatest;
    BccPatches lattice;
    lattice.extent = size.extent();
    const Index cells = cells_between_walls(lattice.extent, cell_side(greatest));
    if (cells[0] == 0)
        return {};
    for (int a = 0; a < 3; ++a)
        lattice.cell[a] = lattice.extent[a] / cells[a];
    lattice.cells = cells;
    mark_used(lattice.corner_used, corner_dims(cells), lattice, 0, size, greatest, run);
    mark_used(lattice.centre_used, cells, lattice, 0.5, size, greatest, run);
    return lattice;
}

}  // namespace cleft
