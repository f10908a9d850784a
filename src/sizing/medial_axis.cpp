// The places of the medial axis, between voxels whose nearest interface points differ. The paper starts its second
// distance transform from them (section 3, Sizing Field).
#include "sizing/medial_axis.hpp"

#include <cmath>

namespace cleft
{
namespace
{

// Interface points of voxel stairs lie up to about half a voxel off the surface, so that the axis of any plane or
// sphere would have branches to each stair. A place m between two voxels counts only if the two interface points p, q
// subtend more than 120 degrees at m and are further apart than any stair (pruning of the integer medial axis), or, in
// a sheet thinner than that, belong to opposite sides of it. Stairs are as high as the greatest spacing.
// A smaller length takes stairs of smooth surfaces for features, and makes sizes too small all along them. A greater
// one leaves more parts to the rule of opposite sides.
constexpr double kStairLength = 4;  // in greatest spacings
// Less than one voxel, the thinnest sheet there is, by what interface points miss.
constexpr double kLeastSheet = 0.8;  // in voxels, each axis by its own spacing
// Of 148 degrees. Normals of two sides of a sheet differ by about 180, those along stairs by far less.
constexpr double kOppositeSides = -0.85;  // cosine of the angle between the normals of two sides of a sheet

struct Position {
    Vec3 point, normal;
};

bool is_medial(const Vec3& m, const Position& p, const Position& q, const Vec3& spacing)
{
    const Vec3 to_p = p.point - m;
    const Vec3 to_q = q.point - m;
    const double dot = to_p.dot(to_q);
    // The cosine of 120 degrees is -1/2. The comparison of squares saves two roots in the innermost loop.
    if (dot >= 0 || 4 * dot * dot <= to_p.squaredNorm() * to_q.squaredNorm())
        return false;
    const Vec3 apart = p.point - q.point;
    const double stair = kStairLength * spacing.maxCoeff();
    if (apart.squaredNorm() > stair * stair)
        return true;
    return p.normal.dot(q.normal) < kOppositeSides &&
           apart.cwiseQuotient(spacing).squaredNorm() > kLeastSheet * kLeastSheet;
}

// Where the way from x along an axis is as far from p as from q, as a part of its length.
double equidistant_part(const Vec3& x, int axis, double length, const Vec3& p, const Vec3& q)
{
    const double slope = 2 * (q - p)[axis] * length;
    const double difference = (q - x).squaredNorm() - (p - x).squaredNorm();
    return slope != 0 ? std::clamp(difference / slope, 0.0, 1.0) : 0.5;
}

class MedialSearch
{
public:
    MedialSearch(const Grid& grid, const InterfacePoints& points, const NearestSites& nearest)
        : grid_(grid),
          coordinates_(grid),
          points_(points),
          nearest_(nearest.site),
          within_(nearest.certain_beside(grid)),
          stride_(grid.strides())
    {
    }

    void row(int32_t j, int32_t k, RowWindow& window, uint8_t* medial) const
    {
        const int64_t start = grid_.index(0, j, k);
        if (!has_differing(j, k))
            return;
        // The rows that hold the next voxel along each axis.
        const Material* own = window.row(j, k);
        const FixedArray<const Material*, 3> next{own + 1, window.row(j + 1, k), window.row(j, k + 1)};
        const int across = (j + 1 < grid_.dims[1]) << 1 | (k + 1 < grid_.dims[2]) << 2;
        for (int32_t i = 0; i < grid_.dims[0]; ++i) {
            const int32_t* site = nearest_.data() + start + i;
            const int axes = across | (i + 1 < grid_.dims[0]);
            int differ = 0;  // those along which the next voxel is of the same material and has another site
            for (int a = 0; a < 3; ++a)
                if ((axes >> a & 1) && next[a][i] == own[i] && site[0] != site[stride_[a]])
                    differ |= 1 << a;
            if (differ == 0 || !is_within({i, j, k}, site[0]))
                continue;
            // A crossing is known to a part of a step, a deepest voxel only to half a voxel: the crossing goes first.
            crossing({i, j, k}, site, differ, medial[i]);
            if (medial[i] == 0 && is_deepest(window, {i, j, k}, site))
                medial[i] = middle_of_deepest({i, j, k}, site);
        }
    }

private:
    // Whether some voxel of a row has another site than the next one along an axis.
    bool has_differing(int32_t j, int32_t k) const
    {
        const int32_t n = grid_.dims[0];
        const int32_t* own = nearest_.data() + grid_.index(0, j, k);
        const int32_t* beside = j + 1 < grid_.dims[1] ? own + stride_[1] : own;
        const int32_t* above = k + 1 < grid_.dims[2] ? own + stride_[2] : own;
        int32_t differ = 0;
        for (int32_t i = 0; i + 1 < n; ++i)
            differ |= (own[i] ^ own[i + 1]) | (own[i] ^ beside[i]) | (own[i] ^ above[i]);
        return (differ | (own[n - 1] ^ beside[n - 1]) | (own[n - 1] ^ above[n - 1])) != 0;
    }

    // Whether the nearest sites of a voxel and of all around it are known.
    bool is_within(const FixedArray<int32_t, 3>& at, int32_t site) const
    {
        if (site < 0)
            return false;
        if (!std::isfinite(within_))
            return true;
        const auto other = coordinates_.of(site);
        return (centre(at) - centre(other)).squaredNorm() <= within_ * within_;
    }

    Vec3 centre(const FixedArray<int32_t, 3>& at) const { return grid_.centre(at[0], at[1], at[2]); }

    Vec3 point(int32_t site) const
    {
        const InterfacePoint& point = points_[site];
        return centre(coordinates_.of(site)) + Vec3(point.offset[0], point.offset[1], point.offset[2]);
    }

    Position position(int32_t site) const
    {
        const InterfacePoint& at = points_[site];
        return {point(site), Vec3(at.normal[0], at.normal[1], at.normal[2])};
    }

    // Whether the voxels of two sites touch, and their normals are not opposite: then no place between them is medial.
    // The most frequent case, seen without their coordinates.
    bool are_alike(int32_t p, int32_t q) const
    {
        // The number of a voxel one step away differs by at most 1 + row + plane. Taking whole planes off leaves what
        // the other two axes add.
        const int64_t apart = std::abs(int64_t{p} - q);
        const int64_t planes = (apart + stride_[1] + 1) / stride_[2];
        const int64_t rest = std::abs(apart - planes * stride_[2]);
        if (planes > 1 || (rest > 1 && std::abs(rest - stride_[1]) > 1))
            return false;
        const auto& n = points_[p].normal;
        const auto& m = points_[q].normal;
        return n[0] * m[0] + n[1] * m[1] + n[2] * m[2] >= kOppositeSides;
    }

    // The place between x and the next voxel along an axis, in steps from x, or -1 if it is not medial.
    double crossing_part(const Vec3& x, int axis, const Position& p, const Position& q) const
    {
        const double part = equidistant_part(x, axis, grid_.spacing[axis], p.point, q.point);
        Vec3 m = x;
        m[axis] += part * grid_.spacing[axis];
        return is_medial(m, p, q, grid_.spacing) ? part : -1;
    }

    // Keeps the crossing whose axis is most nearly that from one interface point to the other: it is the best defined.
    void crossing(const FixedArray<int32_t, 3>& at, const int32_t* site, int axes, uint8_t& held) const
    {
        double best = 0;
        for (int a = 0; a < 3; ++a) {
            if (!(axes >> a & 1))
                continue;
            const int32_t other = site[stride_[a]];
            if (are_alike(site[0], other))
                continue;
            const Position p = position(site[0]);
            const Position q = position(other);
            const Vec3 apart = p.point - q.point;
            const double alignment = apart[a] * apart[a] / apart.squaredNorm();
            const double part = crossing_part(centre(at), a, p, q);
            if (part >= 0 && alignment > best) {
                best = alignment;
                held = pack_medial(a, part);
            }
        }
    }

    // Whether an inner voxel is at least as far from the interface as the neighbours of its material, all 26. Where the
    // axis is a point or a line, as in a ball or a rod, no two neighbours need have points on opposite sides.
    bool is_deepest(RowWindow& window, const FixedArray<int32_t, 3>& at, const int32_t* site) const
    {
        if (points_.contains(site - nearest_.data()))
            return false;
        for (int a = 0; a < 3; ++a) {
            if (grid_.dims[a] == 1)
                continue;
            if (at[a] == 0 || at[a] + 1 == grid_.dims[a])
                return false;
            // The distance to one point is convex: on one side it would be greater.
            if (site[stride_[a]] == site[0] && site[-stride_[a]] == site[0])
                return false;
        }
        const Vec3 inward = centre(at) - point(site[0]);
        const double depth = inward.squaredNorm();
        // The likeliest neighbour first.
        // Nearly all voxels have a deeper neighbour straight ahead. Components above 0.38 of the greatest count as a
        // step, which the factor 1.3 makes of rounding.
        const Eigen::Vector3i ahead = (1.3 * inward / inward.cwiseAbs().maxCoeff()).array().round().cast<int>();
        if (is_deeper(window, at, site, ahead.cwiseMax(-1).cwiseMin(1), depth))
            return false;
        for (int n = 0; n < 27; ++n)
            if (is_deeper(window, at, site, {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1}, depth))
                return false;
        return true;
    }

    // Whether the voxel a step away is of the same material and further from the interface than a squared depth.
    bool is_deeper(RowWindow& window, const FixedArray<int32_t, 3>& at, const int32_t* site,
                   const Eigen::Vector3i& step, double depth) const
    {
        FixedArray<int32_t, 3> to = at;
        int64_t offset = 0;
        for (int a = 0; a < 3; ++a) {
            const int32_t along = step[a];
            if (grid_.dims[a] == 1 && along != 0)
                return false;
            to[a] += along;
            offset += along * stride_[a];
        }
        return (point(site[offset]) - centre(to)).squaredNorm() > depth &&
               window.row(to[1], to[2])[to[0]] == window.row(at[1], at[2])[at[0]];
    }

    // The middle of a deepest voxel and of those next to it that are as deep.
    uint8_t middle_of_deepest(const FixedArray<int32_t, 3>& at, const int32_t* site) const
    {
        const double depth = (point(site[0]) - centre(at)).squaredNorm();
        FixedArray<int, 3> halves{0, 0, 0};
        for (int a = 0; a < 3; ++a)
            for (int side = -1; side <= 1 && grid_.dims[a] > 1; side += 2) {
                FixedArray<int32_t, 3> to = at;
                to[a] += side;
                const double other = (point(site[side * stride_[a]]) - centre(to)).squaredNorm();
                halves[a] += other > depth * (1 - 1e-6) ? side : 0;
            }
        return pack_medial(halves);
    }

    const Grid& grid_;
    VoxelCoordinates coordinates_;
    const InterfacePoints& points_;
    const Array<int32_t>& nearest_;
    double within_;
    FixedArray<int64_t, 3> stride_;
};

}  // namespace

void add_medial_places(const Labelling& labelling, const InterfacePoints& points, const NearestSites& nearest,
                       Array<uint8_t>& medial, const Run& run)
{
    const Grid& grid = labelling.grid;
    const MedialSearch search(grid, points, nearest);
    parallel_with_progress(run, row_count(grid), rows_per_chunk(grid), [&](int64_t, int64_t begin, int64_t end) {
        RowWindow window(labelling);
        for (int64_t row = begin; row < end; ++row)
            search.row(static_cast<int32_t>(row % grid.dims[1]), static_cast<int32_t>(row / grid.dims[1]), window,
                       medial.data() + row * grid.dims[0]);
    });
}

}  // namespace cleft
