// The charge of a sizing field: the integral of h^-3 over the box, from which numbers of tetrahedra follow.
#include "sizing/sizing_charge.hpp"

#include "base/wide_vectors.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

double density(double h) { return 1 / (h * h * h); }

// A voxel among others of about its size stands for its surroundings. Where sizes jump, as in user-supplied fields,
// one small value counts as what interpolation makes of it: a spike around the centre of its voxel.
// A field of gradation 0.3 stays below it between neighbours wherever h is at least 0.6 voxels.
constexpr float kSmooth = 1.5F;  // greatest over least size

bool jumps(float x, float y)
{
    const float less = x < y ? x : y, greater = x < y ? y : x;
    return greater > kSmooth * less;
}

bool jumps(const Array<float>& h, int64_t a, int64_t b) { return jumps(h[a], h[b]); }

// Whether some of `count` values and of those `stride` further jump. No look at each alone: the loop is to be
// vectorized.
CLEFT_WIDE_VECTORS bool some_jump(const float* h, int64_t count, int64_t stride)
{
    int32_t some = 0;
    for (int64_t i = 0; i < count; ++i)
        some |= static_cast<int32_t>(jumps(h[i], h[i + stride]));
    return some != 0;
}

// Fields that are limited by their gradation are smooth mostly, and cost one look.
bool jumps_anywhere(const SizingField& field)
{
    const auto [nx, ny, nz] = field.grid.dims;
    const int64_t row = nx, plane = row * ny;
    for (int32_t k = 0; k < nz; ++k)
        for (int32_t j = 0; j < ny; ++j) {
            const float* h = field.h.data() + field.grid.index(0, j, k);
            if (some_jump(h, row - 1, 1) || (j + 1 < ny && some_jump(h, row, row)) ||
                (k + 1 < nz && some_jump(h, row, plane)))
                return true;
        }
    return false;
}

// The sum of the densities of all voxels, in their order. The quotients are made together; only the sum has to wait.
CLEFT_WIDE_VECTORS double sum_of_densities(const Array<float>& h)
{
    constexpr int64_t kTogether = 256;
    double densities[kTogether];
    double sum = 0;
    for (int64_t first = 0; first < h.count(); first += kTogether) {
        const int64_t count = std::min(kTogether, h.count() - first);
        const float* values = h.data() + first;
        for (int64_t i = 0; i < count; ++i)
            densities[i] = density(static_cast<double>(values[i]));
        for (int64_t i = 0; i < count; ++i)
            sum += densities[i];
    }
    return sum;
}

class VoxelCharge
{
public:
    explicit VoxelCharge(const SizingField& field) : field_(field) {}

    // The mean density of a voxel.
    double mean_density(int64_t voxel)
    {
        if (!jumps_around(voxel))
            return density(static_cast<double>(field_.h[voxel]));
        cells_left_ = kMostCells;
        double sum = 0;  // of the octants, in each of which the field is trilinear
        const int64_t row = field_.grid.dims[0], rows = field_.grid.dims[1], k = voxel / row / rows;
        const Vec3 place(static_cast<double>(voxel % row), static_cast<double>(voxel / row % rows),
                         static_cast<double>(k));
        const Vec3 half = 0.5 * field_.grid.spacing, corner = place.cwiseProduct(field_.grid.spacing);
        for (int octant = 0; octant < 8; ++octant)
            sum += integral(corner + half.cwiseProduct(Vec3(octant & 1, octant >> 1 & 1, octant >> 2)), half, 0);
        return sum / field_.grid.spacing.prod();
    }

private:
    // A spike takes a few cells for each halving of the distance to it; a bound for fields that jump everywhere.
    // A spike that is cut off at these bounds counts for too little; the stages that follow have bounds of their own.
    static constexpr int kMostCells = 4000, kMostHalvings = 150;

    bool jumps_around(int64_t voxel) const
    {
        int64_t stride = 1, rest = voxel;
        for (const int32_t n : field_.grid.dims) {
            const int64_t at = rest % n;
            if ((at > 0 && jumps(field_.h, voxel, voxel - stride)) ||
                (at + 1 < n && jumps(field_.h, voxel, voxel + stride)))
                return true;
            rest /= n;
            stride *= n;
        }
        return false;
    }

    // Halves a box across the axis along which h changes most, until it changes little.
    double integral(const Vec3& low, const Vec3& side, int halvings)
    {
        FixedArray<double, 8> h{};
        for (int c = 0; c < 8; ++c)
            h[c] = field_.at(low + side.cwiseProduct(Vec3(c & 1, c >> 1 & 1, c >> 2)));
        double steepest = 1;
        int across = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int c = 0; c < 8; ++c) {
                const double ratio = h[c] / h[c ^ 1 << axis];
                if (ratio > steepest) {
                    steepest = ratio;
                    across = axis;
                }
            }
        if (steepest <= double{kSmooth} || halvings >= kMostHalvings || --cells_left_ < 0) {
            double corners = 0;
            for (const double value : h)
                corners += density(value) / 8;
            return side.prod() * (corners + 2 * density(field_.at(low + 0.5 * side))) / 3;  // Simpson's rule
        }
        Vec3 half = side, middle = low;
        half[across] /= 2;
        middle[across] += half[across];
        return integral(low, half, halvings + 1) + integral(middle, half, halvings + 1);
    }

    const SizingField& field_;
    int cells_left_ = 0;
};

}  // namespace

double sizing_charge(const SizingField& field, const std::function<bool(int64_t voxel)>& counts)
{
    const bool is_rough = jumps_anywhere(field);
    if (!is_rough && !counts)
        return sum_of_densities(field.h) * field.grid.spacing.prod();
    VoxelCharge charge(field);
    double sum = 0;
    for (int64_t v = 0; v < field.grid.size(); ++v)
        if (!counts || counts(v))
            sum += is_rough ? charge.mean_density(v) : density(static_cast<double>(field.h[v]));
    return sum * field.grid.spacing.prod();
}

}  // namespace cleft
