// Local volume feedback. Eight points of each voxel of the band are given to the materials that hold there. Where a
// material holds less around a voxel than the voxels that carry its label, these voxels gain weight, and lose where it
// holds more.
#include "volume/label_feedback.hpp"

#include "base/parallel.hpp"
#include "volume/label_block.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Each point stands for the octant of a voxel around it.
constexpr int kPoints = 8;  // at (+-1/4, +-1/4, +-1/4) in a voxel
// A box less wide would see less than the kernel blurs; a wider one would let parts pay for each other.
constexpr int kBox = 2;  // the feedback looks at voxels this far away
// A is multiplied by exp(kGain * lack): a material that lacks a tenth of its box gains 35 %. A smaller gain leaves more
// to fitting. A greater one overshoots where labels alternate (damped() below).
constexpr double kGain = 3;
// The bound spares the smooth interfaces of most volumes, where the second round only refines the first.
constexpr double kOvershoot = 0.15;  // of the logarithm of a weight; less is let be
constexpr double kShareOne = 255;    // shares are kept in bytes

// The volume of a voxel by material, as far as feedback needs it.
template <class Label>
struct VoxelShare {
    Label own;
    uint8_t lack;  // of its own material
    Label other[2];
    uint8_t gain[2];  // of the two others that have most of it
};

// The kernel and the bump at the points.
struct PointWeights {
    int reach, width;
    float soft;
    alignas(16) float f[kPoints][kBlockRoom];
    float bumps[2][3];  // at the two offsets along an axis, -1/4 and 1/4

    explicit PointWeights(const Hann& kernel)
        : reach(kernel.width() / 2), width(2 * reach + 1), soft(static_cast<float>(0.5 * kernel.width()))
    {
        float axis[2][kLanes] = {};
        for (int e = 0; e < 2; ++e) {
            const double offset = e ? 0.25 : -0.25;
            for (int i = 0; i < width; ++i)
                axis[e][i] = static_cast<float>(hann(offset - (i - reach), kernel.width()));
            for (int i = 0; i < 3; ++i)
                bumps[e][i] = static_cast<float>(bump(offset - (i - 1)));
        }
        for (int p = 0; p < kPoints; ++p)
            multiply_weights(axis[p & 1], axis[p >> 1 & 1], axis[p >> 2], width, f[p]);
    }
};

// f of the next material at the points, without bumps; the material, or -1 if there is none.
template <class Label>
int next_values(LabelBlock<Label>& block, const PointWeights& at, float* f)
{
    ChunkSum sum[kPoints];
    const int material = block.next([&](int i, ByteChunk weight) {
        if (weight.all_zero())
            return;
        const FloatChunk a(weight);
        for (int p = 0; p < kPoints; ++p)
            sum[p].add(a, at.f[p] + i);
    });
    if (material >= 0)
        for (int p = 0; p < kPoints; ++p)
            f[p] = sum[p].total();
    return material;
}

constexpr int kGreatestMaterials = kGreatestVolume;

// All materials around a voxel with their f at the eight points.
template <class Label>
struct PointValues {
    int count = 0;
    Label material[kGreatestMaterials];
    float f[kGreatestMaterials + 1][kPoints];  // one more: a row for the search that finds none
};

template <class Label>
void add_bumps(const LabelMap<Label>& map, const PointWeights& at, const FixedArray<int32_t, 3>& p,
               PointValues<Label>& out)
{
    const auto& dims = map.grid.dims;
    for (int dz = 0; dz < 3; ++dz)
        for (int dy = 0; dy < 3; ++dy) {
            const int64_t start = map.grid.index(0, mirrored(p[1] + dy - 1, dims[1]), mirrored(p[2] + dz - 1, dims[2]));
            for (int dx = 0; dx < 3; ++dx) {
                const int64_t v = start + mirrored(p[0] + dx - 1, dims[0]);
                const int b = bump_of(map.code[v]);
                if (b == 0)
                    continue;
                const auto k = std::find(out.material, out.material + out.count, map.material[v]) - out.material;
                for (int q = 0; q < kPoints; ++q)
                    out.f[k][q] +=
                        static_cast<float>(b) * at.bumps[q & 1][dx] * at.bumps[q >> 1 & 1][dy] * at.bumps[q >> 2][dz];
            }
        }
}

// Gives each point softly to the best two there; share[k] sums to one over the materials.
// Near a plane across an axis, at distance d, (f1 - f2) / (f1 + f2) is 4 d / width. With `soft` = width / 2 the part
// becomes 1/2 + 2 d. That is the part of an octant of side 1/2 on this side of the plane.
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
VoxelShare<Label> voxel_share(const LabelMap<Label>& map, const PointWeights& at, const FixedArray<int32_t, 3>& p)
{
    LabelBlock<Label> block(map, {p[0] - at.reach, p[1] - at.reach, p[2] - at.reach}, at.width);
    PointValues<Label> values;
    for (;;) {
        const int material = next_values(block, at, values.f[values.count]);
        if (material < 0)
            break;
        CLEFT_ASSERT(values.count < kGreatestMaterials);
        values.material[values.count++] = static_cast<Label>(material);
    }
    add_bumps(map, at, p, values);
    float share[kGreatestMaterials];
    divide_points(values, at.soft, share);

    const Label own = block.centre();
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
// All shares would take 6 bytes per voxel, or 9 with two-byte labels; a window of planes keeps the peak of memory low.
template <class Label>
struct ShareWindow {
    ShareWindow(const Grid& g, int32_t planes_) : grid(g), planes(planes_), row(int64_t{g.dims[0]} + 2 * kBox)
    {
        const int64_t n = row * grid.dims[1] * planes + kChunk;
        own.resize(n);
        lack.resize(n);
        for (int i = 0; i < 2; ++i) {
            other[i].resize(n);
            gain[i].resize(n);
        }
    }
    // The place of the voxel kBox before the first one of a row.
    int64_t start(int32_t y, int32_t z) const { return row * (y + int64_t{grid.dims[1]} * (z % planes)); }
    // A row of voxels that all belong to their own material.
    void clear_row(int64_t start)
    {
        for (auto* plane : {&lack, &gain[0], &gain[1]})
            std::fill_n(plane->begin() + start, row, uint8_t{0});
    }
    void set(int64_t i, const VoxelShare<Label>& s)
    {
        own[i] = s.own;
        lack[i] = s.lack;
        for (int e = 0; e < 2; ++e) {
            other[e][i] = s.other[e];
            gain[e][i] = s.gain[e];
        }
    }
    void copy(int64_t from, int64_t to)
    {
        set(to, {own[from], lack[from], {other[0][from], other[1][from]}, {gain[0][from], gain[1][from]}});
    }

    Grid grid;
    int32_t planes;
    int64_t row;
    Array<Label> own, other[2];
    Array<uint8_t> lack, gain[2];
};

template <class Label>
void fill_row(const LabelMap<Label>& map, const PointWeights& at, int32_t y, int32_t z, ShareWindow<Label>& window)
{
    const int32_t nx = map.grid.dims[0];
    const int64_t voxels = map.grid.index(0, y, z), start = window.start(y, z);
    window.clear_row(start);
    for (int32_t x = 0; x < nx; ++x) {
        const int64_t v = voxels + x, i = start + kBox + x;
        window.own[i] = map.material[v];
        if (in_band(map.code[v]))
            window.set(i, voxel_share(map, at, {x, y, z}));
    }
    for (int32_t x = -kBox; x < 0; ++x)
        window.copy(start + kBox + mirrored(x, nx), start + kBox + x);
    for (int32_t x = nx; x < nx + kBox; ++x)
        window.copy(start + kBox + mirrored(x, nx), start + kBox + x);
}

// Half a voxel of the outermost ones: the box has sides of four voxels.
constexpr int kBoxWeight[kLanes] = {1, 2, 2, 2, 1};
// The sum over a box is at most 64 * 255 in magnitude, so 16-bit lanes hold it.
constexpr int kBoxRows = 25;
constexpr double kBoxTotal = 8 * 8 * 8;

// How much of the volume around voxel x of a row its own material lacks, -1 .. 1. rows: where the 25 rows around start.
template <class Label>
double lack_around(const ShareWindow<Label>& window, Label own, const int64_t* rows, int32_t x)
{
    WordSum sum;
    for (int r = 0; r < kBoxRows; ++r) {
        const auto held = [&, i = rows[r] + x](const Array<Label>& material, const Array<uint8_t>& part) {
            return ByteChunk::equal(&material[i], own) & ByteChunk::load(&part[i]);
        };
        // A voxel lists a material once, so at most one of the two gains counts.
        sum.add(kBoxWeight[r / 5] * kBoxWeight[r % 5], held(window.own, window.lack),
                held(window.other[0], window.gain[0]) | held(window.other[1], window.gain[1]));
    }
    int16_t lanes[kLanes];
    sum.store(lanes);
    int total = 0;
    for (int i = 0; i < kLanes; ++i)
        total += kBoxWeight[i] * lanes[i];
    return total / (kShareOne * kBoxTotal);
}

// By what the logarithm of a weight changes in the second round, where feedback asks for `change` and the first round
// made it `first`. Where voxels of two materials alternate, a round can overshoot by more than it mends, and the next
// one by more again: there the weight goes to where the line through the two errors is zero.
double damped(double first, double change)
{
    if (first * change > 0 || std::abs(change) < std::max(kOvershoot, std::abs(first)))
        return change;
    // The secant through the errors before and after the first round; both have opposite signs here, so it lies
    // between.
    return first * change / (first - change);
}

template <class Label>
void correct_row(LabelMap<Label>& map, const ShareWindow<Label>& window, int32_t y, int32_t z, FeedbackRound round)
{
    const auto& dims = map.grid.dims;
    int64_t rows[kBoxRows];
    for (int r = 0; r < kBoxRows; ++r)
        rows[r] = window.start(mirrored(y + r % 5 - kBox, dims[1]), mirrored(z + r / 5 - kBox, dims[2]));
    const int64_t voxels = map.grid.index(0, y, z);
    for (int32_t x = 0; x < dims[0]; ++x) {
        const int64_t v = voxels + x;
        if (!in_band(map.code[v]))
            continue;
        const double weight = map.weight[v];
        double change = kGain * lack_around(window, map.material[v], rows, x);
        if (round == FeedbackRound::second)
            change = damped(std::log(weight / kWeightOne), change);
        const double a = weight * std::exp(change);
        map.weight[v] = static_cast<uint8_t>(std::lround(std::clamp<double>(a, kWeightLeast, kWeightGreatest)));
    }
}

}  // namespace

template <class Label>
void feed_back_volume(LabelMap<Label>& map, FeedbackRound round, const Run& run)
{
    constexpr int32_t kSlab = 8;
    const auto [nx, ny, nz] = map.grid.dims;
    const PointWeights at(map.kernel);
    // Shares run ahead of the correction: no share is taken from a weight of this round.
    // Otherwise the result would depend on the order of the rows, and so on the threads.
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
        run.report(static_cast<double>(z0) / nz);
        const int32_t z1 = std::min(nz, z0 + kSlab);
        const int32_t fill = std::min(nz, z1 + ahead);
        rows(filled, fill, [&](int32_t y, int32_t z) { fill_row(map, at, y, z, window); });
        filled = fill;
        rows(z0, z1, [&](int32_t y, int32_t z) { correct_row(map, window, y, z, round); });
    }
}

template void feed_back_volume(LabelMap<uint8_t>&, FeedbackRound, const Run&);
template void feed_back_volume(LabelMap<uint16_t>&, FeedbackRound, const Run&);

}  // namespace cleft
