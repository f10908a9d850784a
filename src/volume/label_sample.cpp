#include "volume/label_sample.hpp"

#include "volume/label_block.hpp"
#include "volume/position.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

constexpr int kGreatestShares = 6 * 6 * 6;

// What one point sees: f_k of every material around it, in order of discovery.
struct Shares {
    int count = 0;
    Material material[kGreatestShares];
    double value[kGreatestShares];
    double gradient[kGreatestShares][3];  // by voxel index
};

// The voxel whose centre is nearest to a point.
size_t voxel_at(const Grid& grid, const std::array<double, 3>& u)
{
    const auto [i, j, k] = nearest_voxel(grid, u);
    return static_cast<size_t>(grid.index(i, j, k));
}

template <bool WithGradient>
void contract(const uint8_t (*weights)[kLanes], int width, const std::array<AxisWeights, 3>& axis, double& value,
              double* gradient)
{
    float sum[kLanes] = {}, sum_dy[kLanes] = {}, sum_dz[kLanes] = {};
    for (int z = 0, r = 0; z < width; ++z) {
        float plane[kLanes] = {}, plane_dy[kLanes] = {};
        for (int y = 0; y < width; ++y, ++r)
            for (int i = 0; i < kLanes; ++i) {
                const auto a = static_cast<float>(weights[r][i]);
                plane[i] += axis[1].w[y] * a;
                if (WithGradient)
                    plane_dy[i] += axis[1].dw[y] * a;
            }
        for (int i = 0; i < kLanes; ++i) {
            sum[i] += axis[2].w[z] * plane[i];
            if (WithGradient) {
                sum_dy[i] += axis[2].w[z] * plane_dy[i];
                sum_dz[i] += axis[2].dw[z] * plane[i];
            }
        }
    }
    constexpr double step = 1.0 / kWeightOne;
    double f = 0, dx = 0, dy = 0, dz = 0;
    for (int i = 0; i < width; ++i) {
        f += double{axis[0].w[i]} * sum[i];
        if (WithGradient) {
            dx += double{axis[0].dw[i]} * sum[i];
            dy += double{axis[0].w[i]} * sum_dy[i];
            dz += double{axis[0].w[i]} * sum_dz[i];
        }
    }
    value = step * f;
    if (WithGradient) {
        gradient[0] = step * dx;
        gradient[1] = step * dy;
        gradient[2] = step * dz;
    }
}

template <class Label, bool WithGradient>
void add_bumps(const LabelMap<Label>& map, const std::array<double, 3>& u, Shares& out)
{
    std::array<int32_t, 3> cell;
    double w[3][2], dw[3][2];
    for (size_t a = 0; a < 3; ++a) {
        const double low = std::floor(u[a]);
        cell[a] = static_cast<int32_t>(low);
        for (int e = 0; e < 2; ++e) {
            w[a][e] = bump(u[a] - low - e);
            dw[a][e] = bump_slope(u[a] - low - e);
        }
    }
    for (int corner = 0; corner < 8; ++corner) {
        const int e[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
        const auto v = static_cast<size_t>(map.grid.index(mirrored(cell[0] + e[0], map.grid.dims[0]),
                                                          mirrored(cell[1] + e[1], map.grid.dims[1]),
                                                          mirrored(cell[2] + e[2], map.grid.dims[2])));
        const int code = bump_of(map.code[v]);
        if (code == 0)
            continue;
        const double b = code * (1.0 / kWeightOne);
        const Material material = map.material[v];
        const auto k = std::find(out.material, out.material + out.count, material) - out.material;
        const double wx = w[0][e[0]], wy = w[1][e[1]], wz = w[2][e[2]];
        out.value[k] += b * wx * wy * wz;
        if (WithGradient) {
            out.gradient[k][0] += b * dw[0][e[0]] * wy * wz;
            out.gradient[k][1] += b * wx * dw[1][e[1]] * wz;
            out.gradient[k][2] += b * wx * wy * dw[2][e[2]];
        }
    }
}

template <class Label, bool WithGradient>
void find_shares(const LabelMap<Label>& map, const std::array<double, 3>& u, Shares& out)
{
    std::array<AxisWeights, 3> axis;
    std::array<int32_t, 3> first;
    for (size_t a = 0; a < 3; ++a) {
        map.kernel.weights(u[a], axis[a]);
        first[a] = axis[a].first;
    }
    const LabelBlock<Label> block(map, first, map.kernel.width());
    BlockMaterials<Label> materials(block);
    alignas(16) uint8_t weights[kGreatestRows][kLanes];
    out.count = 0;
    Label material;
    while (materials.next(material, weights)) {
        out.material[out.count] = material;
        contract<WithGradient>(weights, block.width(), axis, out.value[out.count], out.gradient[out.count]);
        ++out.count;
    }
    add_bumps<Label, WithGradient>(map, u, out);
}

// Ascending by material, without those that have no share.
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

template <class Label, bool WithGradient>
void sample_shares(const LabelMap<Label>& map, const Vec3& x, Samples& out)
{
    const auto u = voxel_position(map.grid, x);
    const auto nearest = voxel_at(map.grid, u);
    if (depth_of(map.code[nearest]) >= map.reach())
        return single(map.material[nearest], WithGradient, out);

    Shares shares;
    find_shares<Label, WithGradient>(map, u, shares);
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
    const auto n = static_cast<size_t>(count);
    out.material.resize(n);
    out.value.resize(n);
    if (WithGradient)
        out.gradient.resize(n);
    for (size_t i = 0; i < n; ++i) {
        const int k = entries[i];
        out.material[i] = shares.material[k];
        out.value[i] = shares.value[k] / sum;
        if (WithGradient)
            out.gradient[i] =
                (Eigen::Map<const Vec3>(shares.gradient[k]) - out.value[i] * sum_gradient).cwiseProduct(by_length) /
                sum;
    }
}

}  // namespace

template <class Label>
void sample(const LabelMap<Label>& map, const Vec3& x, Samples& out)
{
    sample_shares<Label, false>(map, x, out);
}

template <class Label>
void sample_gradient(const LabelMap<Label>& map, const Vec3& x, Samples& out)
{
    sample_shares<Label, true>(map, x, out);
}

template <class Label>
Material material_at(const LabelMap<Label>& map, const Vec3& x)
{
    const auto u = voxel_position(map.grid, x);
    const auto nearest = voxel_at(map.grid, u);
    if (depth_of(map.code[nearest]) >= map.reach())
        return map.material[nearest];
    Shares shares;
    find_shares<Label, false>(map, u, shares);
    int best = 0;
    for (int i = 1; i < shares.count; ++i)
        if (shares.value[i] > shares.value[best] ||
            (shares.value[i] == shares.value[best] && shares.material[i] < shares.material[best]))
            best = i;
    return shares.material[best];
}

template <class Label>
bool single_material_near(const LabelMap<Label>& map, const Vec3& x, double reach)
{
    const auto u = voxel_position(map.grid, x);
    const auto nearest = nearest_voxel(map.grid, u);
    const int depth = depth_of(map.code[static_cast<size_t>(map.grid.index(nearest[0], nearest[1], nearest[2]))]);
    // A point within `reach` sees the voxels less than half a kernel farther; the block of one material around the
    // nearest voxel ends before the centres at depth + 1.
    for (size_t a = 0; a < 3; ++a) {
        const double offset = std::abs(u[a] - nearest[a]) + reach / map.grid.spacing[static_cast<int>(a)];
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
