// Raster scans with the 13 neighbours that a scan has passed (Danielsson's vector propagation with all neighbours):
// each voxel carries the voxel b whose cone is the lowest found so far, and offers it to the voxels that follow. The
// cell of a cone need not be connected through neighbouring voxels, so a few voxels can miss their best cone; a last
// pair of scans with the plain distances to the neighbours (a chamfer transform) closes the gaps.
#include "sizing/gradient_limit.hpp"

#include "base/stage.hpp"
#include "base/touched_array.hpp"
#include "base/wide_vectors.hpp"
#include "sizing/chamfer_scan.hpp"
#include "sizing/raster_scan.hpp"
#include "sizing/wavefront.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace cleft
{
namespace
{

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The cones that the voxels of a row carry: apex (in voxels) and the value there. One unused voxel at either end.
struct ConeRow {
    Array<float> x, y, z, value;
    Array<int32_t> apex;

    void resize(int32_t n)
    {
        for (auto* v : {&x, &y, &z})
            v->assign(n + 2, 0);
        value.assign(n + 2, kInfinity);
        apex.assign(n + 2, -1);
    }
};

// One scan of all rows. While cones are carried, a voxel stores its cone's apex and the value there, and not the value
// of the cone at the voxel: that follows from both, and the cone travels on without a rounding.
// A sum along the way, as a chamfer transform has it, overestimates oblique distances by up to 13 %. That would show as
// facets in the sizes.
class ConeScan
{
public:
    ConeScan(const Grid& grid, double gradation, Array<float>& value, Array<int32_t>& apex, const RasterScan& scan)
        : grid_(grid), value_(value), apex_(apex), scan_(scan)
    {
        // Lengths in units of the greatest spacing: their squares stay within the range of float.
        const double unit = grid.spacing.maxCoeff();
        for (int a = 0; a < 3; ++a)
            spacing_[a] = static_cast<float>(grid.spacing[a] / unit);
        slope_ = static_cast<float>(gradation * unit);
        scratch_.resize(std::min(kWavefrontBatch, grid.dims[2]));
        for (Scratch& s : scratch_) {
            for (ConeRow& row : s.rows)
                row.resize(grid.dims[0]);
            s.squared.resize(grid.dims[0] + 2);
            s.best.resize(grid.dims[0]);
            s.pick.resize(grid.dims[0]);
        }
    }

    void row(int32_t plane, int32_t row);
    void finish(const Run& run);

private:
    // The rows a plane works with: three of the plane before, two of its own, each in a slot by its number.
    struct Scratch {
        FixedArray<ConeRow, 5> rows;
        Array<float> squared;  // distance in y and z from an apex to the row that is worked on
        Array<float> best;
        Array<int32_t> pick;  // which neighbour offered the best
    };

    // A plane needs three rows of the one before, and each is loaded once while it is among them.
    static int slot_before(int32_t row) { return row % 3; }
    static int slot_own(int32_t row) { return 3 + row % 2; }

    void load(int32_t j, int32_t k, ConeRow& out) const;
    void evaluate(int32_t j, int32_t k, const ConeRow& row, float* h) const;
    void offer(const ConeRow& from, int32_t number, int32_t j, int32_t k, Scratch& s) const;
    void take(const FixedArray<const ConeRow*, 4>& from, Scratch& s, ConeRow& own) const;
    void along(int32_t j, int32_t k, ConeRow& own, float* best) const;

    const Grid& grid_;
    Array<float>& value_;  // at the apex
    Array<int32_t>& apex_;
    RasterScan scan_;
    FixedArray<float, 3> spacing_{};
    float slope_ = 0;
    Array<Scratch> scratch_;  // by plane, of those under way
};

CLEFT_WIDE_VECTORS void ConeScan::load(int32_t j, int32_t k, ConeRow& out) const
{
    const int64_t start = grid_.index(0, j, k);
    const int32_t n = grid_.dims[0];
    std::copy_n(value_.data() + start, n, out.value.data() + 1);
    std::copy_n(apex_.data() + start, n, out.apex.data() + 1);
    const int32_t* CLEFT_RESTRICT apex = out.apex.data() + 1;
    float* CLEFT_RESTRICT x = out.x.data() + 1;
    float* CLEFT_RESTRICT y = out.y.data() + 1;
    float* CLEFT_RESTRICT z = out.z.data() + 1;
    // As VoxelCoordinates, but with numbers of 32 bits alone: the loop is to be vectorized.
    const int32_t per_row = n, per_plane = n * grid_.dims[1];
    const double rows = 1.0 / per_row, planes = 1.0 / per_plane;
    for (int32_t i = 0; i < n; ++i) {
        const auto plane = static_cast<int32_t>((apex[i] + 0.5) * planes);
        const int32_t in_plane = apex[i] - plane * per_plane;
        const auto row = static_cast<int32_t>((in_plane + 0.5) * rows);
        x[i] = static_cast<float>(in_plane - row * per_row);
        y[i] = static_cast<float>(row);
        z[i] = static_cast<float>(plane);
    }
}

// The values of a row's own cones at its voxels.
CLEFT_WIDE_VECTORS void ConeScan::evaluate(int32_t j, int32_t k, const ConeRow& row, float* h) const
{
    const float* CLEFT_RESTRICT x = row.x.data() + 1;
    const float* CLEFT_RESTRICT y = row.y.data() + 1;
    const float* CLEFT_RESTRICT z = row.z.data() + 1;
    const float* CLEFT_RESTRICT value = row.value.data() + 1;
    float* CLEFT_RESTRICT out = h;
    const auto fj = static_cast<float>(j);
    const auto fk = static_cast<float>(k);
    const float sx = spacing_[0], sy = spacing_[1], sz = spacing_[2], slope = slope_;
    for (int32_t i = 0; i < grid_.dims[0]; ++i) {
        const float dx = (static_cast<float>(i) - x[i]) * sx;
        const float dy = (fj - y[i]) * sy;
        const float dz = (fk - z[i]) * sz;
        out[i] = value[i] + slope * std::sqrt(dx * dx + dy * dy + dz * dz);
    }
}

// Offers the cones of a row to the row (j, k): each voxel compares those of the three voxels next to it.
CLEFT_WIDE_VECTORS void ConeScan::offer(const ConeRow& from, int32_t number, int32_t j, int32_t k, Scratch& s) const
{
    const int32_t n = grid_.dims[0];
    const float* CLEFT_RESTRICT x = from.x.data();
    const float* CLEFT_RESTRICT y = from.y.data();
    const float* CLEFT_RESTRICT z = from.z.data();
    const float* CLEFT_RESTRICT value = from.value.data();
    float* CLEFT_RESTRICT squared = s.squared.data();
    const auto fj = static_cast<float>(j);
    const auto fk = static_cast<float>(k);
    const float sx = spacing_[0], sy = spacing_[1], sz = spacing_[2], slope = slope_;
    for (int32_t c = 0; c < n + 2; ++c) {
        const float dy = (fj - y[c]) * sy;
        const float dz = (fk - z[c]) * sz;
        squared[c] = dy * dy + dz * dz;
    }
    float* CLEFT_RESTRICT best = s.best.data();
    int32_t* CLEFT_RESTRICT pick = s.pick.data();
    const int32_t code = 3 * number;
    for (int32_t shift = 0; shift < 3; ++shift) {
        for (int32_t i = 0; i < n; ++i) {
            const float dx = (static_cast<float>(i) - x[i + shift]) * sx;
            const float offered = value[i + shift] + slope * std::sqrt(dx * dx + squared[i + shift]);
            const float held = best[i];
            const int32_t better = -static_cast<int32_t>(offered < held);  // a mask: the loop is to be vectorized
            best[i] = offered < held ? offered : held;
            pick[i] = (pick[i] & ~better) | ((code + shift) & better);
        }
    }
}

// Once, after all offers: only the best of them is copied.
void ConeScan::take(const FixedArray<const ConeRow*, 4>& from, Scratch& s, ConeRow& own) const
{
    for (int32_t i = 0; i < grid_.dims[0]; ++i) {
        const int32_t pick = s.pick[i];
        if (pick < 0)
            continue;
        CLEFT_ASSERT(from[pick / 3]);
        const ConeRow& row = *from[pick / 3];
        const int32_t c = i + pick % 3, o = i + 1;
        own.x[o] = row.x[c];
        own.y[o] = row.y[c];
        own.z[o] = row.z[c];
        own.value[o] = row.value[c];
        own.apex[o] = row.apex[c];
    }
}

// Offers each voxel's cone to the next one of the row.
void ConeScan::along(int32_t j, int32_t k, ConeRow& own, float* best) const
{
    const float step = slope_ * spacing_[0];
    for (int32_t t = 1; t < grid_.dims[0]; ++t) {
        const int32_t i = scan_.at(0, t, grid_);
        const int32_t before = i - scan_.sign[0];
        if (best[before] - step >= best[i])
            continue;  // no cone grows by less than that
        const int32_t c = before + 1;
        const float dx = (static_cast<float>(i) - own.x[c]) * spacing_[0];
        const float dy = (static_cast<float>(j) - own.y[c]) * spacing_[1];
        const float dz = (static_cast<float>(k) - own.z[c]) * spacing_[2];
        const float offered = own.value[c] + slope_ * std::sqrt(dx * dx + dy * dy + dz * dz);
        if (offered >= best[i])
            continue;
        const int32_t o = i + 1;
        best[i] = offered;
        own.x[o] = own.x[c];
        own.y[o] = own.y[c];
        own.z[o] = own.z[c];
        own.value[o] = own.value[c];
        own.apex[o] = own.apex[c];
    }
}

void ConeScan::row(int32_t plane, int32_t row)
{
    Scratch& s = scratch_[plane % kWavefrontBatch];
    const int32_t k = scan_.at(2, plane, grid_);
    const int32_t j = scan_.at(1, row, grid_);
    ConeRow& own = s.rows[slot_own(row)];
    load(j, k, own);
    evaluate(j, k, own, s.best.data());
    std::fill(s.pick.begin(), s.pick.end(), -1);

    FixedArray<const ConeRow*, 4> from{};
    if (plane > 0) {
        for (int32_t r = row == 0 ? 0 : row + 1; r <= std::min(row + 1, grid_.dims[1] - 1); ++r)
            load(scan_.at(1, r, grid_), scan_.at(2, plane - 1, grid_), s.rows[slot_before(r)]);
        for (int32_t d = -1; d <= 1; ++d)
            if (row + d >= 0 && row + d < grid_.dims[1])
                from[d + 1] = &s.rows[slot_before(row + d)];
    }
    if (row > 0)
        from[3] = &s.rows[slot_own(row - 1)];
    for (int32_t f = 0; f < 4; ++f)
        if (from[f])
            offer(*from[f], f, j, k, s);
    take(from, s, own);
    along(j, k, own, s.best.data());

    const int64_t start = grid_.index(0, j, k);
    const int32_t n = grid_.dims[0];
    std::copy_n(own.value.data() + 1, n, value_.data() + start);
    std::copy_n(own.apex.data() + 1, n, apex_.data() + start);
}

// Turns the values at the apexes into the values of the cones at the voxels.
void ConeScan::finish(const Run& run)
{
    parallel_with_progress(run, row_count(grid_), rows_per_chunk(grid_), [&](int64_t, int64_t begin, int64_t end) {
        ConeRow cones;
        cones.resize(grid_.dims[0]);
        for (int64_t row = begin; row < end; ++row) {
            const auto j = static_cast<int32_t>(row % grid_.dims[1]);
            const auto k = static_cast<int32_t>(row / grid_.dims[1]);
            load(j, k, cones);
            evaluate(j, k, cones, value_.data() + row * grid_.dims[0]);
        }
    });
}

}  // namespace

void limit_gradient(const Grid& grid, double gradation, Array<float>& h, const Run& run)
{
    CLEFT_ASSERT(h.count() == grid.size() && gradation > 0);
    // Two opposite scans pass every neighbour once. Two more along another diagonal reach most voxels that these leave
    // with a worse cone.
    constexpr std::array<RasterScan, 4> kScans{{{{1, 1, 1}}, {{-1, -1, -1}}, {{1, -1, 1}}, {{-1, 1, -1}}}};
    Steps steps(run, Array<Step>(kScans.size() + 3, {"sizing: gradation", 1}));
    constexpr int64_t kVoxelsAtOnce = 1 << 16;
    Array<int32_t> apex = large_array<int32_t>(run, h.size());
    parallel_for(run, apex.count(), kVoxelsAtOnce, [&](int64_t begin, int64_t end) {
        std::iota(apex.begin() + begin, apex.begin() + end, static_cast<int32_t>(begin));
    });
    for (const RasterScan& scan : kScans) {
        ConeScan cones(grid, gradation, h, apex, scan);
        wavefront(steps.next(), grid.dims[2], grid.dims[1], [&](int32_t plane, int32_t row) { cones.row(plane, row); });
    }
    ConeScan(grid, gradation, h, apex, kScans[0]).finish(steps.next());
    // For plain distances two opposite scans are exact, since their steps add up along any path.
    for (const RasterScan& scan : {kScans[0], kScans[1]}) {
        ChamferScan chamfer(grid, gradation, h, scan);
        wavefront(steps.next(), grid.dims[2], grid.dims[1],
                  [&](int32_t plane, int32_t row) { chamfer.row(plane, row); });
    }
}

}  // namespace cleft
