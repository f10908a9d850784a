// Local volume feedback. Eight points of each voxel of the band are given to the materials that hold there. Where a
// material holds less around a voxel than the voxels that carry its label, these voxels gain weight, and lose where it
// holds more.
#include "volume/label_weights.hpp"

#include "base/parallel.hpp"
#include "volume/label_block.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

constexpr int kPoints = 8;  // at (+-1/4, +-1/4, +-1/4) in a voxel
constexpr int kBox = 2;     // the feedback looks at voxels this far away
constexpr double kGain = 3;
constexpr double kShareOne = 255;  // shares are kept in bytes

// The volume of a voxel by material, as far as feedback needs it.
template <class Label>
struct VoxelShare {
    Label own;
    uint8_t lack;  // of its own material
    Label other[2];
    uint8_t gain[2];  // of the two others that have most of it
};

// The kernel and the bump at the two offsets -1/4 and 1/4 of a voxel.
struct PointWeights {
    int reach;
    float soft;
    float w[2][kLanes] = {};
    float s[2][3];

    explicit PointWeights(const Hann& kernel)
        : reach(kernel.width() / 2), soft(static_cast<float>(0.5 * kernel.width()))
    {
        for (int e = 0; e < 2; ++e) {
            for (int i = 0; i <= 2 * reach; ++i)
                w[e][i] = static_cast<float>(hann((e ? 0.25 : -0.25) - (i - reach), kernel.width()));
            for (int i = 0; i < 3; ++i)
                s[e][i] = static_cast<float>(bump((e ? 0.25 : -0.25) - (i - 1)));
        }
    }
};

// f of one material at the eight points.
void contract(const uint8_t (*weights)[kLanes], int width, const PointWeights& at, float* f)
{
    float yz[4][kLanes] = {};
    for (int z = 0, r = 0; z < width; ++z) {
        float y[2][kLanes] = {};
        for (int j = 0; j < width; ++j, ++r)
            for (int i = 0; i < kLanes; ++i) {
                const auto a = static_cast<float>(weights[r][i]);
                y[0][i] += at.w[0][j] * a;
                y[1][i] += at.w[1][j] * a;
            }
        for (int i = 0; i < kLanes; ++i) {
            yz[0][i] += at.w[0][z] * y[0][i];
            yz[1][i] += at.w[0][z] * y[1][i];
            yz[2][i] += at.w[1][z] * y[0][i];
            yz[3][i] += at.w[1][z] * y[1][i];
        }
    }
    for (int p = 0; p < kPoints; ++p) {
        float sum = 0;
        for (int i = 0; i < width; ++i)
            sum += at.w[p & 1][i] * yz[p >> 1][i];
        f[p] = sum;
    }
}

constexpr int kGreatestMaterials = kGreatestRows * kGreatestBlock;

// All materials around a voxel with their f at the eight points.
template <class Label>
struct PointValues {
    int count = 0;
    Label material[kGreatestMaterials + 1];  // one more: the place where a further one would go
    float f[kGreatestMaterials][kPoints];
};

template <class Label>
void add_bumps(const LabelMap<Label>& map, const PointWeights& at, const std::array<int32_t, 3>& p,
               PointValues<Label>& out)
{
    const auto& dims = map.grid.dims;
    for (int dz = 0; dz < 3; ++dz)
        for (int dy = 0; dy < 3; ++dy) {
            const int64_t start = map.grid.index(0, mirrored(p[1] + dy - 1, dims[1]), mirrored(p[2] + dz - 1, dims[2]));
            for (int dx = 0; dx < 3; ++dx) {
                const auto v = static_cast<size_t>(start + mirrored(p[0] + dx - 1, dims[0]));
                const int b = bump_of(map.code[v]);
                if (b == 0)
                    continue;
                const auto k = std::find(out.material, out.material + out.count, map.material[v]) - out.material;
                for (int q = 0; q < kPoints; ++q)
                    out.f[k][q] += static_cast<float>(b) * at.s[q & 1][dx] * at.s[q >> 1 & 1][dy] * at.s[q >> 2][dz];
            }
        }
}

// Gives each point softly to the best two there; share[k] sums to one over the materials.
template <class Label>
void divide_points(const PointValues<Label>& values, float soft, float* share)
{
    std::fill(share, share + values.count, 0.0f);
    for (int p = 0; p < kPoints; ++p) {
        int best = 0, second = 0;
        float f1 = -1, f2 = -1;
        for (int k = 0; k < values.count; ++k) {
            const float f = values.f[k][p];
            if (f > f1) {
                f2 = f1;
                second = best;
                f1 = f;
                best = k;
            } else if (f > f2) {
                f2 = f;
                second = k;
            }
        }
        const float part = std::min(1.0f, 0.5f + soft * (f1 - f2) / (f1 + f2));
        share[best] += part / kPoints;
        share[second] += (1 - part) / kPoints;
    }
}

template <class Label>
VoxelShare<Label> voxel_share(const LabelMap<Label>& map, const PointWeights& at, const std::array<int32_t, 3>& p)
{
    const int width = 2 * at.reach + 1;
    const LabelBlock<Label> block(map, {p[0] - at.reach, p[1] - at.reach, p[2] - at.reach}, width);
    BlockMaterials<Label> materials(block);
    PointValues<Label> values;
    uint8_t weights[kGreatestRows][kLanes];
    while (materials.next(values.material[values.count], weights)) {
        contract(weights, width, at, values.f[values.count]);
        ++values.count;
    }
    add_bumps(map, at, p, values);
    float share[kGreatestMaterials];
    divide_points(values, at.soft, share);

    const Label own = block.material(at.reach, at.reach)[at.reach];
    VoxelShare<Label> out{own, 0, {own, own}, {0, 0}};
    float most[2] = {0, 0};
    for (int k = 0; k < values.count; ++k) {
        if (values.material[k] == own) {
            out.lack = static_cast<uint8_t>(std::lround(kShareOne * std::max(0.0f, 1 - share[k])));
            continue;
        }
        const int slot = share[k] > most[0] ? 0 : share[k] > most[1] ? 1 : 2;
        if (slot == 0) {
            most[1] = most[0];
            out.other[1] = out.other[0];
        }
        if (slot < 2) {
            most[slot] = share[k];
            out.other[slot] = values.material[k];
        }
    }
    for (int i = 0; i < 2; ++i)
        out.gain[i] = static_cast<uint8_t>(std::lround(kShareOne * std::min(1.0f, most[i])));
    return out;
}

// The shares of the planes around the one that is worked on, as structure of arrays. Rows have kBox mirrored voxels
// before and behind, so that whole lanes can be read around any voxel.
template <class Label>
struct ShareWindow {
    ShareWindow(const Grid& g, int32_t planes_) : grid(g), planes(planes_), row(int64_t{g.dims[0]} + 2 * kBox)
    {
        const auto n = static_cast<size_t>(row * grid.dims[1] * planes) + kLanes;
        own.resize(n);
        lack.resize(n);
        for (int i = 0; i < 2; ++i) {
            other[i].resize(n);
            gain[i].resize(n);
        }
    }
    // The place of the voxel kBox before the first one of a row.
    size_t start(int32_t y, int32_t z) const
    {
        return static_cast<size_t>(row * (y + int64_t{grid.dims[1]} * (z % planes)));
    }
    void set(size_t i, const VoxelShare<Label>& s)
    {
        own[i] = s.own;
        lack[i] = s.lack;
        for (int e = 0; e < 2; ++e) {
            other[e][i] = s.other[e];
            gain[e][i] = s.gain[e];
        }
    }
    void copy(size_t from, size_t to)
    {
        set(to, {own[from], lack[from], {other[0][from], other[1][from]}, {gain[0][from], gain[1][from]}});
    }

    Grid grid;
    int32_t planes;
    int64_t row;
    std::vector<Label> own, other[2];
    std::vector<uint8_t> lack, gain[2];
};

template <class Label>
void fill_row(const LabelMap<Label>& map, const PointWeights& at, int32_t y, int32_t z, ShareWindow<Label>& window)
{
    const int32_t nx = map.grid.dims[0];
    const auto voxels = static_cast<size_t>(map.grid.index(0, y, z));
    const size_t start = window.start(y, z);
    for (int32_t x = 0; x < nx; ++x) {
        const size_t v = voxels + static_cast<size_t>(x);
        const Label own = map.material[v];
        const VoxelShare<Label> whole{own, 0, {own, own}, {0, 0}};
        window.set(start + kBox + static_cast<size_t>(x),
                   in_band(map.code[v]) ? voxel_share(map, at, {x, y, z}) : whole);
    }
    for (int32_t x = -kBox; x < 0; ++x)
        window.copy(start + kBox + static_cast<size_t>(mirrored(x, nx)), start + static_cast<size_t>(x + kBox));
    for (int32_t x = nx; x < nx + kBox; ++x)
        window.copy(start + kBox + static_cast<size_t>(mirrored(x, nx)), start + static_cast<size_t>(x + kBox));
}

// How much of the volume around a voxel its own material lacks, -1 .. 1.
template <class Label>
double lack_around(const ShareWindow<Label>& window, Label own, const std::array<int32_t, 3>& p)
{
    static constexpr int kRow[kLanes] = {1, 2, 2, 2, 1, 0, 0, 0};
    const auto& dims = window.grid.dims;
    int sum = 0;
    for (int dz = 0; dz < 5; ++dz)
        for (int dy = 0; dy < 5; ++dy) {
            const size_t i = window.start(mirrored(p[1] + dy - kBox, dims[1]), mirrored(p[2] + dz - kBox, dims[2])) +
                             static_cast<size_t>(p[0]);
            int row = 0;
            for (size_t e = 0; e < kLanes; ++e) {
                row += window.own[i + e] == own ? kRow[e] * window.lack[i + e] : 0;
                row -= window.other[0][i + e] == own ? kRow[e] * window.gain[0][i + e] : 0;
                row -= window.other[1][i + e] == own ? kRow[e] * window.gain[1][i + e] : 0;
            }
            sum += kRow[dz] * kRow[dy] * row;
        }
    return sum / (kShareOne * 512);
}

template <class Label>
void correct_row(LabelMap<Label>& map, const ShareWindow<Label>& window, int32_t y, int32_t z)
{
    const auto voxels = static_cast<size_t>(map.grid.index(0, y, z));
    for (int32_t x = 0; x < map.grid.dims[0]; ++x) {
        const size_t v = voxels + static_cast<size_t>(x);
        if (!in_band(map.code[v]))
            continue;
        const double a = map.weight[v] * std::exp(kGain * lack_around(window, map.material[v], {x, y, z}));
        map.weight[v] = static_cast<uint8_t>(std::lround(std::clamp<double>(a, kWeightLeast, kWeightGreatest)));
    }
}

}  // namespace

template <class Label>
void feed_back_volume(LabelMap<Label>& map, double progress, const Run& run)
{
    constexpr int32_t kSlab = 8;
    const auto [nx, ny, nz] = map.grid.dims;
    const PointWeights at(map.kernel);
    // Shares run ahead of the correction: no share is taken from a weight of this round.
    const int32_t ahead = std::max(kBox, at.reach);
    ShareWindow<Label> window(map.grid, std::min(nz, kBox + kSlab + ahead));
    const auto rows = [&, ny = ny](int32_t z0, int32_t z1, const auto& body) {
        parallel_for(run, int64_t{ny} * (z1 - z0), 4, [&](int64_t begin, int64_t end) {
            for (int64_t row = begin; row < end; ++row)
                body(static_cast<int32_t>(row % ny), static_cast<int32_t>(z0 + row / ny));
        });
    };
    int32_t filled = 0;
    for (int32_t z0 = 0; z0 < nz; z0 += kSlab) {
        run.report(progress, "volume");
        const int32_t z1 = std::min(nz, z0 + kSlab);
        const int32_t fill = std::min(nz, z1 + ahead);
        rows(filled, fill, [&](int32_t y, int32_t z) { fill_row(map, at, y, z, window); });
        filled = fill;
        rows(z0, z1, [&](int32_t y, int32_t z) { correct_row(map, window, y, z); });
    }
}

template void feed_back_volume(LabelMap<uint8_t>&, double, const Run&);
template void feed_back_volume(LabelMap<uint16_t>&, double, const Run&);

}  // namespace cleft
