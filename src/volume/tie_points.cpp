// Searches between voxel centres whose materials differ: only there can interfaces pass.
#include "volume/tie_points.hpp"

#include "base/collect.hpp"
#include "volume/tie.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Rows of voxels that a thread takes. The number changes the time alone.
constexpr int64_t kRowsAtOnce = 64;
// Of a step between centres: a line may cross the plane of a square so far beside it. Where interfaces meet at a small
// angle, the square whose corners have the three materials is not the one that the line crosses.
constexpr double kBeside = 0.5;
// Of the least spacing. What find_cut() leaves is less, and so is what interpolation does to a crease.
constexpr double kHeldWithin = 0.1;

// The materials of row (j, k) of voxels and of those after it, and where they differ.
class Rows
{
public:
    explicit Rows(const Volume& volume) : volume_(volume), is_mixed_(volume.grid().dims[0]) {}

    void read(int32_t j, int32_t k)
    {
        if (k == k_ && j == j_ + 1) {
            std::swap(rows_[0], rows_[1]);
            std::swap(rows_[2], rows_[3]);
        } else {
            read_row(0, j, k);
            read_row(2, j, k);
        }
        read_row(1, j, k);
        read_row(3, j, k);
        j_ = j;
        k_ = k;
        find_mixed();
    }

    // 0 to 3: (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1). Empty past the grid.
    const Array<Material>& operator[](int r) const { return rows_[r]; }

    // visit(i) for each voxel of the first row that has another material than one of the seven after it: the next along
    // each of the axes.
    template <class Visit>
    void for_each_mixed(const Visit& visit) const
    {
        // Most voxels are inside of a material: they are passed by together.
        const uint8_t* const first = is_mixed_.data();
        const uint8_t* const last = first + is_mixed_.size();
        for (const uint8_t* at = first; at != last; ++at) {
            at = std::find(at, last, uint8_t{1});
            if (at == last)
                break;
            visit(static_cast<int32_t>(at - first));
        }
    }

private:
    void read_row(int r, int32_t j, int32_t k)
    {
        const Grid& grid = volume_.grid();
        const int32_t at_j = j + r % 2, at_k = k + r / 2;
        const bool is_inside = at_j < grid.dims[1] && at_k < grid.dims[2];
        rows_[r].resize(is_inside ? grid.dims[0] : 0);
        if (is_inside)
            volume_.voxel_materials(grid.index(0, at_j, at_k), grid.dims[0], rows_[r].data());
    }

    // Without a branch at each voxel, so that the loop vectorizes.
    void find_mixed()
    {
        const auto data_of = [&](int r) { return rows_[r].empty() ? rows_[0].data() : rows_[r].data(); };
        const Material* const own = rows_[0].data();
        const Material *const b = data_of(1), *const c = data_of(2), *const d = data_of(3);
        const auto across = [&](int64_t i) { return (own[i] ^ b[i]) | (own[i] ^ c[i]) | (own[i] ^ d[i]); };
        const int64_t last = is_mixed_.count() - 1;
        for (int64_t i = 0; i < last; ++i)
            is_mixed_[i] = (across(i) | across(i + 1) | (own[i] ^ own[i + 1])) != 0;
        is_mixed_[last] = across(last) != 0;
    }

    const Volume& volume_;
    FixedArray<Array<Material>, 4> rows_;
    Array<uint8_t> is_mixed_;
    int32_t j_ = -1, k_ = -1;
};

// What body(rows, j, k, samples, points) adds for each row of voxels, in the order of the rows.
template <class Body>
Array<TiePoint> collect_from_rows(const Volume& volume, const Run& run, const Body& body)
{
    const Grid& grid = volume.grid();
    return collect<TiePoint>(run, int64_t{grid.dims[1]} * grid.dims[2], kRowsAtOnce,
                             [&](int64_t begin, int64_t end, Array<TiePoint>& points) {
                                 Rows rows(volume);
                                 Samples samples;
                                 for (int64_t row = begin; row < end; ++row) {
                                     const auto j = static_cast<int32_t>(row % grid.dims[1]);
                                     const auto k = static_cast<int32_t>(row / grid.dims[1]);
                                     rows.read(j, k);
                                     body(rows, j, k, samples, points);
                                 }
                             });
}

// The crossing between the centres a and b.
void add_crossing(const Volume& volume, const Vec3& a, const Vec3& b, Material of_a, Material of_b, Samples& samples,
                  Array<TiePoint>& points)
{
    const MaterialSet first(of_a), second(of_b);
    const auto difference_at = [&](const Vec3& x) {
        volume.sample(x, samples);
        return greatest_value(samples, first) - greatest_value(samples, second);
    };
    const double at_a = difference_at(a), at_b = difference_at(b);
    const Vec3 x = a + find_cut(volume, {a, b, first, second, at_a, at_b}, samples) * (b - a);
    TiePoint point{{{std::min(of_a, of_b), std::max(of_a, of_b), kNoThird}}, x};
    if (is_held_by(volume, x, point.of.set(), kHeldWithin * volume.grid().spacing.minCoeff(), samples))
        points.push_back(point);
}

// The crossing of a line with the square of four centres around `middle`, across the axis `across`.
void add_line_crossing(const Volume& volume, const Vec3& middle, int across, const TieMaterials& of, Samples& samples,
                       Array<TiePoint>& points)
{
    const Vec3& spacing = volume.grid().spacing;
    const MaterialSet set = of.set();
    const auto x = project_to_tie(volume, middle, middle, set, 1u << across, 2 * spacing.maxCoeff(), samples);
    if (!x || ((*x - middle).cwiseAbs().array() > (0.5 + kBeside) * spacing.array()).any())
        return;
    if (is_held_by(volume, *x, set, kHeldWithin * spacing.minCoeff(), samples))
        points.push_back({of, *x});
}

// Of four materials any three may meet in a line.
void add_line_crossings(const Volume& volume, const Vec3& middle, int across, FixedArray<Material, 4> corner,
                        Samples& samples, Array<TiePoint>& points)
{
    std::sort(corner.begin(), corner.end());
    const auto count = std::unique(corner.begin(), corner.end()) - corner.begin();
    if (count == 3)
        add_line_crossing(volume, middle, across, {{corner[0], corner[1], corner[2]}}, samples, points);
    if (count < 4)
        return;
    for (int without = 3; without >= 0; --without) {
        TieMaterials of;
        for (int i = 0, n = 0; i < 4; ++i)
            if (i != without)
                of.material[n++] = corner[i];
        add_line_crossing(volume, middle, across, of, samples, points);
    }
}

}  // namespace

MaterialSet TieMaterials::set() const
{
    MaterialSet all(material[0]);
    all.unite(MaterialSet(material[1]));
    if (is_line())
        all.unite(MaterialSet(material[2]));
    return all;
}

bool is_held_by(const Volume& volume, const Vec3& x, const MaterialSet& set, double tolerance, Samples& scratch)
{
    volume.sample_gradient(x, scratch);
    const size_t best = scratch.best();
    if (std::find(set.begin(), set.end(), scratch.material[best]) != set.end())
        return true;
    const double lead = scratch.value[best] - greatest_value(scratch, set);
    for (const Material m : set)
        if (const int i = scratch.find(m); i >= 0)
            return lead <= tolerance * (scratch.gradient[best] - scratch.gradient[i]).norm();
    return false;
}

Array<TiePoint> find_interface_points(const Volume& volume, const Run& run)
{
    const Grid& grid = volume.grid();
    const auto add_of_row = [&](const Rows& rows, int32_t j, int32_t k, Samples& samples, Array<TiePoint>& points) {
        rows.for_each_mixed([&](int32_t i) {
            const Vec3 centre = grid.centre(i, j, k);
            const auto look = [&](const Array<Material>& row, int32_t there, int axis) {
                if (there >= row.count() || row[there] == rows[0][i])
                    return;
                Vec3 next = centre;
                next[axis] += grid.spacing[axis];
                add_crossing(volume, centre, next, rows[0][i], row[there], samples, points);
            };
            look(rows[0], i + 1, 0);
            look(rows[1], i, 1);
            look(rows[2], i, 2);
        });
    };
    return collect_from_rows(volume, run, add_of_row);
}

Array<TiePoint> find_line_points(const Volume& volume, const Run& run)
{
    const Grid& grid = volume.grid();
    const auto add_of_row = [&](const Rows& rows, int32_t j, int32_t k, Samples& samples, Array<TiePoint>& points) {
        rows.for_each_mixed([&](int32_t i) {
            // The square from the voxel to one step along two axes, whose far corners are in `row` and `far_row`.
            const auto look = [&](const Array<Material>& row, const Array<Material>& far_row, int32_t there,
                                  int across) {
                if (i + there >= grid.dims[0] || row.empty() || far_row.empty())
                    return;
                const bool is_along_x = there > 0;
                const Material second = is_along_x ? rows[0][i + 1] : rows[2][i];
                Vec3 half = 0.5 * grid.spacing;
                half[across] = 0;
                add_line_crossings(volume, grid.centre(i, j, k) + half, across,
                                   {rows[0][i], second, row[i], far_row[i + there]}, samples, points);
            };
            look(rows[1], rows[1], 1, 2);
            look(rows[2], rows[2], 1, 1);
            look(rows[1], rows[3], 0, 0);
        });
    };
    return collect_from_rows(volume, run, add_of_row);
}

}  // namespace cleft
