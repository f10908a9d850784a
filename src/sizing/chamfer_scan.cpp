// The rows that were passed first, all voxels of a row side by side; then the row itself, voxel after voxel, where that
// changes anything.
#include "sizing/chamfer_scan.hpp"

#include "base/wide_vectors.hpp"

#include <algorithm>
#include <limits>

namespace cleft
{
namespace
{

// A row and the steps to it, straight and aslant.
struct PassedRow {
    const float* h;
    float straight, aslant;
};

// Of row f from the voxels around i.
CLEFT_ALWAYS_INLINE float offer(const PassedRow& from, int32_t i)
{
    const float before = from.h[i - 1], after = from.h[i + 1];
    const float side = (before < after ? before : after) + from.aslant;
    const float here = from.h[i] + from.straight;
    return side < here ? side : here;
}

CLEFT_WIDE_VECTORS void take_inner(const FixedArray<PassedRow, 4>& passed, int32_t n, float* CLEFT_RESTRICT h)
{
    const PassedRow a = passed[0], b = passed[1], c = passed[2], d = passed[3];
    for (int32_t i = 1; i + 1 < n; ++i) {
        const float of_a = offer(a, i), of_b = offer(b, i), of_c = offer(c, i), of_d = offer(d, i);
        const float ab = of_a < of_b ? of_a : of_b, cd = of_c < of_d ? of_c : of_d;
        const float least = ab < cd ? ab : cd;
        h[i] = least < h[i] ? least : h[i];
    }
}

// At the ends of a row, which have one neighbour along it or none.
void take_ends(const FixedArray<PassedRow, 4>& passed, int32_t n, float* h)
{
    for (const PassedRow& from : passed)
        for (const int32_t i : {0, n - 1}) {
            h[i] = std::min(h[i], from.h[i] + from.straight);
            if (n > 1)
                h[i] = std::min(h[i], from.h[i == 0 ? 1 : n - 2] + from.aslant);
        }
}

// Voxels of a row that are looked at together.
constexpr int32_t kRowsTogether = 32;

// Whether one of the voxels is above the one before it by more than a step.
CLEFT_ALWAYS_INLINE bool some_exceed(const float* h, int32_t sign, float step)
{
    int32_t some = 0;
    for (int32_t i = 0; i < kRowsTogether; ++i)
        some |= static_cast<int32_t>(h[i - sign] + step < h[i]);
    return some != 0;
}

// Along the row. A voxel that is not above the one before it changes only after that.
CLEFT_WIDE_VECTORS void take_along(int32_t n, int32_t sign, float step, float* h)
{
    for (int32_t t = 1; t < n;) {
        const int32_t i = sign > 0 ? t : n - 1 - t;
        if (t + kRowsTogether <= n && !some_exceed(sign > 0 ? h + i : h + i - (kRowsTogether - 1), sign, step)) {
            t += kRowsTogether;
            continue;
        }
        const int32_t end = std::min(n, t + kRowsTogether);
        for (; t < end; ++t) {
            const int32_t v = sign > 0 ? t : n - 1 - t;
            h[v] = std::min(h[v], h[v - sign] + step);
        }
    }
}

}  // namespace

ChamferScan::ChamferScan(const Grid& grid, double gradation, Array<float>& h, const RasterScan& direction)
    : grid_(grid), h_(h), direction_(direction), no_row_(grid.dims[0], std::numeric_limits<float>::infinity())
{
    for (int dk = 0; dk < 2; ++dk)
        for (int dj = 0; dj < 2; ++dj)
            for (int di = 0; di < 2; ++di) {
                const double length = Vec3(di, dj, dk).cwiseProduct(grid.spacing).norm();
                step_[4 * dk + 2 * dj + di] = static_cast<float>(gradation * length);
            }
}

void ChamferScan::row(int32_t plane, int32_t row)
{
    const int32_t n = grid_.dims[0];
    FixedArray<PassedRow, 4> passed;
    for (int32_t d = -1; d <= 1; ++d) {
        const bool is_there = plane > 0 && row + d >= 0 && row + d < grid_.dims[1];
        const int offset = d == 0 ? 4 : 6;
        passed[d + 1] = {is_there ? at(plane - 1, row + d) : no_row_.data(), step_[offset], step_[offset + 1]};
    }
    passed[3] = {row > 0 ? at(plane, row - 1) : no_row_.data(), step_[2], step_[3]};
    float* const h = at(plane, row);
    take_inner(passed, n, h);
    take_ends(passed, n, h);
    take_along(n, direction_.sign[0], step_[1], h);
}

}  // namespace cleft
