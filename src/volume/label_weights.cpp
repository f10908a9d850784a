// The weights of a label map. They depend on each other, so the order is: bumps of thin parts, feedback on A, then the
// bumps that are still missing.
#include "volume/label_weights.hpp"

#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "volume/label_block.hpp"
#include "volume/label_feedback.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// By how much a voxel centre must at least prefer its own material, in units of f.
// More than the rounding of the sums of floats, so that no centre is decided by rounding. A greater margin would push
// interfaces away from the centres that need it.
constexpr double kMargin = 0.02;

// The kernel at a voxel centre.
struct CentreWeights {
    int reach, width;
    alignas(16) float f[kBlockRoom];

    explicit CentreWeights(const Hann& kernel) : reach(kernel.width() / 2), width(2 * reach + 1)
    {
        float axis[kLanes] = {};
        for (int i = 0; i < width; ++i)
            axis[i] = static_cast<float>(hann(i - reach, kernel.width()));
        multiply_weights(axis, axis, axis, width, f);
    }
};

// f of the voxel's own material minus the best other one, at its centre, without its bump.
template <class Label>
double lead_at_centre(const LabelMap<Label>& map, const CentreWeights& at, const FixedArray<int32_t, 3>& p)
{
    LabelBlock<Label> block(map, {p[0] - at.reach, p[1] - at.reach, p[2] - at.reach}, at.width);
    float own = 0, other = 0;
    for (;;) {
        ChunkSum f;
        const int material = block.next([&](int i, ByteChunk weight) { f.add(FloatChunk(weight), at.f + i); });
        if (material < 0)
            return double{own - other} / kWeightOne;
        float& place = material == block.centre() ? own : other;
        place = std::max(place, f.total());
    }
}

// True if the voxel lies in a run of at most two equal voxels along an axis. A half-space has none.
// A kernel of 5 voxels gives a single voxel 0.4^3 = 0.064 at its own centre. A of at most 2.9 cannot make that win, so
// that feedback needs these bumps first.
template <class Label>
bool is_thin(const LabelMap<Label>& map, const FixedArray<int32_t, 3>& p)
{
    const auto& dims = map.grid.dims;
    const Label own = map.material[map.grid.index(p[0], p[1], p[2])];
    for (int a = 0; a < 3; ++a) {
        bool same[5];
        for (int o = -2; o <= 2; ++o) {
            auto q = p;
            q[a] = mirrored(p[a] + o, dims[a]);
            same[o + 2] = map.material[map.grid.index(q[0], q[1], q[2])] == own;
        }
        if (!((same[0] && same[1]) || (same[1] && same[3]) || (same[3] && same[4])))
            return true;
    }
    return false;
}

// body(x, y, z, voxel) for every voxel of the band.
template <class Label, class Body>
void for_band(const LabelMap<Label>& map, const Run& run, const Body& body)
{
    // Planes between two reports: enough rows for all threads, and few enough for a smooth bar.
    constexpr int32_t kSlab = 8;
    const auto [nx, ny, nz] = map.grid.dims;
    for (int32_t z0 = 0; z0 < nz; z0 += kSlab) {
        run.report(static_cast<double>(z0) / nz);
        const int64_t rows = int64_t{ny} * std::min(kSlab, nz - z0);
        parallel_for(run, rows, 4, [&, nx = nx, ny = ny](int64_t begin, int64_t end) {
            for (int64_t row = begin; row < end; ++row) {
                const auto y = static_cast<int32_t>(row % ny), z = static_cast<int32_t>(z0 + row / ny);
                const int64_t start = map.grid.index(0, y, z);
                for (int32_t x = 0; x < nx; ++x)
                    if (in_band(map.code[start + x]))
                        body(x, y, z, start + x);
            }
        });
    }
}

// What a thin voxel lacks at its centre shows how thin it is: fitted so that a sheet, a rod and a single voxel keep
// their volumes.
uint8_t thin_bump(double lead)
{
    // At width 5 a sheet of two voxels leads by 0.32 and gets no bump. A sheet of one voxel has a lead of -0.2.
    const double lack = 0.25 - lead;
    if (lack <= 0)
        return 0;
    const double b = 0.37 * lack + 1.9 * lack * lack;
    return static_cast<uint8_t>(std::min<double>(kBumpGreatest, std::round(kWeightOne * b)));
}

}  // namespace

template <class Label>
void find_weights(LabelMap<Label>& map, const Run& run)
{
    const CentreWeights centre(map.kernel);
    Steps steps(run, {{nullptr, 1}, {nullptr, 3}, {nullptr, 3}, {nullptr, 1}});
    for_band(map, steps.next(), [&](int32_t x, int32_t y, int32_t z, int64_t v) {
        if (is_thin(map, {x, y, z}))
            map.code[v] = thin_bump(lead_at_centre(map, centre, {x, y, z}));
    });
    // Two rounds: what is left after them is for fitting, which sees the mesh itself.
    feed_back_volume(map, FeedbackRound::first, steps.next());
    feed_back_volume(map, FeedbackRound::second, steps.next());
    // A bump moves no other centre, so one pass in any order is exact.
    for_band(map, steps.next(), [&](int32_t x, int32_t y, int32_t z, int64_t v) {
        const double lack = kMargin - lead_at_centre(map, centre, {x, y, z});
        CLEFT_ASSERT(std::ceil(kWeightOne * lack) <= kBumpGreatest);
        if (lack > 0)
            map.code[v] = std::max(map.code[v], static_cast<uint8_t>(std::ceil(kWeightOne * lack)));
    });
}

template void find_weights(LabelMap<uint8_t>&, const Run&);
template void find_weights(LabelMap<uint16_t>&, const Run&);

}  // namespace cleft
