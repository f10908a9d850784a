// Shares of the materials at a point of a label map. All of a run goes through here, so it works on whole chunks of
// voxels and takes a short way deep inside a material.
#include "volume/label_sample.hpp"

#include "volume/label_block.hpp"
#include "volume/position.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cleft
{

namespace
{

// The widest kernel covers six voxels along each axis, and each may have a label of its own.
constexpr int kGreatestShares = 6 * 6 * 6;

// What one point sees: f_k of every material around it, in order of discovery.
struct Shares {
    int count = 0;
    Material material[kGreatestShares];
    double value[kGreatestShares];
    double gradient[kGreatestShares][3];  // by voxel index
};

// Where the map has the voxel whose centre is nearest to a point.
template <class Label>
int64_t voxel_at(const LabelMap<Label>& map, const FixedArray<int32_t, 3>& nearest)
{
    // Stages ask for the planes around what they work on. If one went further, another part of memory would be read.
    if (!map.planes.has(nearest[2]))
        throw std::logic_error("a place outside the planes of voxels that are held was sampled");
    return map.index(nearest[0], nearest[1], nearest[2]);
}

// The kernel for every voxel of a block, and its derivatives by x, y and z.
struct BlockWeights {
    alignas(16) float f[kBlockRoom];
    alignas(16) float slope[3][kBlockRoom];

    template <bool WithGradient>
    void set(const KernelWeights& k, int width)
    {
        multiply_weights(k.w[0], k.w[1], k.w[2], width, f);
        if (WithGradient) {
            multiply_weights(k.dw[0], k.w[1], k.w[2], width, slope[0]);
            multiply_weights(k.w[0], k.dw[1], k.w[2], width, slope[1]);
            multiply_weights(k.w[0], k.w[1], k.dw[2], width, slope[2]);
        }
    }
};

// The part of the kernel in f of the next material; false when there is none.
template <bool WithGradient, class Label>
bool next_share(LabelBlock<Label>& block, const BlockWeights& weights, Shares& out)
{
    ChunkSum f, slope[3];
    const int material = block.next([&](int i, ByteChunk weight) {
        const FloatChunk a(weight);
        f.add(a, weights.f + i);
        if (WithGradient)
            for (int d = 0; d < 3; ++d)
                slope[d].add(a, weights.slope[d] + i);
    });
    if (material < 0)
        return false;
    constexpr double kStep = 1.0 / kWeightOne;
    CLEFT_ASSERT(out.count < kGreatestShares);
    const int k = out.count++;
    out.material[k] = material;
    out.value[k] = kStep * f.total();
    if (WithGradient)
        for (int d = 0; d < 3; ++d)
            out.gradient[k][d] = kStep * slope[d].total();
    return true;
}

// The eight voxels whose centres are around a point, x fastest.
struct Corners {
    int64_t voxel[8];
    double offset[3];  // from the first of them

    template <class Label>
    Corners(const LabelMap<Label>& map, const FixedArray<double, 3>& u)
    {
        const Grid& grid = map.grid;
        int64_t step[3][2];
        const int64_t stride[3] = {1, grid.dims[0], int64_t{grid.dims[0]} * grid.dims[1]};
        for (int a = 0; a < 3; ++a) {
            // Truncation is the floor here, since u is at least -1/2. Past the wall the mirror image of a corner is the
            // corner next to it, so that clamping is enough.
            const int32_t low = static_cast<int32_t>(u[a] + 1) - 1;
            offset[a] = u[a] - low;
            step[a][0] = stride[a] * std::max(low, 0);
            step[a][1] = stride[a] * std::min(low + 1, grid.dims[a] - 1);
        }
        for (int c = 0; c < 8; ++c)
            voxel[c] = step[0][c & 1] + step[1][c >> 1 & 1] + step[2][c >> 2] - map.first;
    }
};

template <bool WithGradient, class Label>
void add_bumps(const LabelMap<Label>& map, const FixedArray<double, 3>& u, Shares& out)
{
    const Corners corners(map, u);
    // Most points have no bump around: only parts that are thin, and centres that lost their label, have one.
    int any = 0;
    for (const int64_t v : corners.voxel)
        any |= bump_of(map.code[v]);
    if (!any)
        return;
    double w[3][2], dw[3][2];
    for (int a = 0; a < 3; ++a)
        for (int e = 0; e < 2; ++e) {
            w[a][e] = bump(corners.offset[a] - e);
            dw[a][e] = bump_slope(corners.offset[a] - e);
        }
    for (int c = 0; c < 8; ++c) {
        const int64_t v = corners.voxel[c];
        const double b = bump_of(map.code[v]) * (1.0 / kWeightOne);
        const auto k = std::find(out.material, out.material + out.count, Material{map.material[v]}) - out.material;
        // A corner outside the kernel's block is there by rounding, and its bump is as small.
        if (b == 0 || k == out.count)
            continue;
        const int x = c & 1, y = c >> 1 & 1, z = c >> 2;
        out.value[k] += b * w[0][x] * w[1][y] * w[2][z];
        if (WithGradient) {
            out.gradient[k][0] += b * dw[0][x] * w[1][y] * w[2][z];
            out.gradient[k][1] += b * w[0][x] * dw[1][y] * w[2][z];
            out.gradient[k][2] += b * w[0][x] * w[1][y] * dw[2][z];
        }
    }
}

template <bool WithGradient, class Label>
void find_shares(const LabelMap<Label>& map, const FixedArray<double, 3>& u, Shares& out)
{
    const int width = map.kernel.width();
    KernelWeights kernel;
    map.kernel.template weights<WithGradient>(u, kernel);
    LabelBlock<Label> block(map, kernel.first, width);
    BlockWeights weights;
    weights.set<WithGradient>(kernel, width);
    out.count = 0;
    while (next_share<WithGradient>(block, weights, out)) {
    }
    add_bumps<WithGradient>(map, u, out);
}

// Ascending by material, without those that have no share.
// Samples promises this order. It also makes the sum below independent of which voxel was met first.
void order(Shares& s, int* entries, int& count)
{
    count = 0;
    for (int i = 0; i < s.count; ++i) {
        if (!(s.value[i] > 0))
            continue;
        int at = count++;
        for (; at > 0 && s.material[entries[at - 1]] > s.material[i]; --at)
            entries[at] = entries[at - 1];
        entries[at] = i;
    }
}

void single(Material material, bool with_gradient, Samples& out)
{
    out.material.assign(1, material);
    out.value.assign(1, 1.0);
    if (with_gradient)
        out.gradient.assign(1, Vec3::Zero());
}

template <bool WithGradient, class Label>
void sample_shares(const LabelMap<Label>& map, const Vec3& x, Samples& out)
{
    const auto u = voxel_position(map.grid, x);
    const auto nearest = voxel_at(map, nearest_voxel(map.grid, u));
    if (depth_of(map.code[nearest]) >= map.reach())
        // No voxel of another material is within reach of the kernel, so the share is exactly 1 and its gradient 0.
        return single(map.material[nearest], WithGradient, out);

    Shares shares;
    find_shares<WithGradient>(map, u, shares);
    int entries[kGreatestShares], count;
    order(shares, entries, count);
    double sum = 0;
    Vec3 sum_gradient = Vec3::Zero();
    const Vec3 by_length = map.grid.spacing.cwiseInverse();
    for (int i = 0; i < count; ++i) {
        sum += shares.value[entries[i]];
        if (WithGradient)
            sum_gradient += Eigen::Map<const Vec3>(shares.gradient[entries[i]]);
    }
    // The nearest voxel at least has a share.
    CLEFT_ASSERT(sum > 0);
    out.material.resize(count);
    out.value.resize(count);
    if (WithGradient)
        out.gradient.resize(count);
    for (int i = 0; i < count; ++i) {
        const int k = entries[i];
        out.material[i] = shares.material[k];
        out.value[i] = shares.value[k] / sum;
        if (WithGradient)
            // The rule for quotients: shares add up to one, so their gradients add up to zero.
            out.gradient[i] =
                (Eigen::Map<const Vec3>(shares.gradient[k]) - out.value[i] * sum_gradient).cwiseProduct(by_length) /
                sum;
    }
}

}  // namespace

template <class Label>
void sample(const LabelMap<Label>& map, const Vec3& x, Samples& out)
{
    sample_shares<false>(map, x, out);
}

template <class Label>
void sample_gradient(const LabelMap<Label>& map, const Vec3& x, Samples& out)
{
    sample_shares<true>(map, x, out);
}

template <class Label>
Material material_at(const LabelMap<Label>& map, const Vec3& x)
{
    const auto u = voxel_position(map.grid, x);
    const auto nearest = voxel_at(map, nearest_voxel(map.grid, u));
    if (depth_of(map.code[nearest]) >= map.reach())
        return map.material[nearest];
    Shares shares;
    find_shares<false>(map, u, shares);
    int best = 0;
    for (int i = 1; i < shares.count; ++i)
        if (wins(shares.value[i], shares.material[i], shares.value[best], shares.material[best]))
            best = i;
    return shares.material[best];
}

template <class Label>
bool single_material_near(const LabelMap<Label>& map, const Vec3& x, double reach)
{
    const auto u = voxel_position(map.grid, x);
    const auto nearest = nearest_voxel(map.grid, u);
    const int depth = depth_of(map.code[voxel_at(map, nearest)]);
    // A point within `reach` sees the voxels less than half a kernel farther; the block of one material around the
    // nearest voxel ends before the centres at depth + 1.
    for (int a = 0; a < 3; ++a) {
        const double offset = std::abs(u[a] - nearest[a]) + reach / map.grid.spacing[a];
        if (!(offset + 0.5 * map.kernel.width() <= depth + 1))
            return false;
    }
    return true;
}

#define CLEFT_INSTANTIATE(Label)                                                  \
    template void sample(const LabelMap<Label>&, const Vec3&, Samples&);          \
    template void sample_gradient(const LabelMap<Label>&, const Vec3&, Samples&); \
    template Material material_at(const LabelMap<Label>&, const Vec3&);           \
    template bool single_material_near(const LabelMap<Label>&, const Vec3&, double)
CLEFT_INSTANTIATE(uint8_t);
CLEFT_INSTANTIATE(uint16_t);
#undef CLEFT_INSTANTIATE

}  // namespace cleft
