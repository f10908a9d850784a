// One axis after the other (Felzenszwalb, Huttenlocher 2012; Maurer, Qi, Raghavan 2003): along a line of voxels the
// squared distances to the sites found so far are parabolas of one width, and their lower envelope is built by a stack.
#include "sizing/feature_transform.hpp"

#include "base/stage.hpp"

namespace cleft
{
namespace
{

// Columns that are worked on together, so that a cache line of a strided read is used whole.
// 16 numbers of 4 bytes fill a line of 64 bytes.
constexpr int32_t kBlockWidth = 16;

// Voxels along an axis that are within the reach.
int32_t steps_within(double reach, const Grid& grid, int axis)
{
    const int32_t n = grid.dims[axis];
    return reach < n * grid.spacing[axis] ? static_cast<int32_t>(reach / grid.spacing[axis]) : n;
}

bool has_site(const int32_t* sites, int64_t count)
{
    int32_t all = -1;  // the sign: all are negative
    for (int64_t i = 0; i < count; ++i)
        all &= sites[i];
    return all >= 0;
}

// Within `reach` voxels.
void transform_row(int32_t* row, int32_t first, int32_t n, int32_t reach)
{
    int32_t last = -1;
    for (int32_t i = 0; i < n; ++i) {
        CLEFT_ASSERT(row[i] < 0 || row[i] == first + i);
        if (row[i] >= 0)
            last = row[i];
        row[i] = last >= 0 && first + i - last > reach ? -1 : last;
    }
    int32_t next = -1;
    for (int32_t i = n - 1; i >= 0; --i) {
        const int32_t here = first + i;
        if (row[i] == here)
            next = here;
        // Strictly nearer: of two sites at equal distance the lower one stays, whatever the direction of the pass.
        else if (next >= 0 && next - here <= reach && (row[i] < 0 || next - here < here - row[i]))
            row[i] = next;
    }
}

// By block of kBlockWidth voxels of a row: whether some of them have a site.
struct HeldBlocks {
    int64_t in_row;
    Array<uint8_t> held;

    explicit HeldBlocks(const Grid& grid)
        : in_row(chunk_count(grid.dims[0], kBlockWidth)), held(row_count(grid) * in_row)
    {
    }
};

// The lines of voxels along one axis, with the sites in the space of the axes before it. Places along a line are in
// voxels, squared distances are divided by the squared spacing of the line.
struct Columns {
    const Grid& grid;
    int axis;
    int64_t stride;
    double per_row;              // 1 / dims[0]
    double x_ratio, y_ratio;     // squared ratios of the spacings to that of the line
    double most;                 // squared distance within the reach
    int32_t reach;               // along the line
    Array<double> half_inverse;  // 1 / (2 d)

    Columns(const Grid& g, int a, double in_world)
        : grid(g),
          axis(a),
          stride(g.strides()[a]),
          per_row(1.0 / g.dims[0]),
          most(in_world / g.spacing[a] * (in_world / g.spacing[a])),
          reach(steps_within(in_world, g, a))
    {
        const Vec3 ratio = g.spacing / g.spacing[a];
        x_ratio = ratio[0] * ratio[0];
        y_ratio = a == 1 ? 0 : ratio[1] * ratio[1];
        half_inverse.resize(length());
        for (size_t d = 1; d < half_inverse.size(); ++d)
            half_inverse[d] = 0.5 / static_cast<double>(d);
    }

    int32_t length() const { return grid.dims[axis]; }
    int64_t blocks_in_row() const { return chunk_count(grid.dims[0], kBlockWidth); }
    int64_t count() const { return blocks_in_row() * grid.dims[3 - axis]; }

    // The row that holds place y of a column.
    int64_t row(int64_t y, int32_t other) const
    {
        return axis == 1 ? int64_t{other} * grid.dims[1] + y : y * grid.dims[1] + other;
    }
    // The first voxel of the row (axis 1) or plane (axis 2) that holds place y of a column: the sites there were found
    // in it.
    int64_t first_voxel(int64_t y, int32_t other) const
    {
        return axis == 1 ? row(y, other) * grid.dims[0] : y * stride;
    }

    // Squared distance from the column (i, other) to the voxel that is `number` after the first of its row or plane,
    // within the plane that is orthogonal to the axis.
    // Sites carry only their number. Multiplying by a reciprocal costs less than a division; the half keeps it exact
    // (VoxelCoordinates says why).
    double squared_offset(int32_t number, int32_t i, int32_t other) const
    {
        const auto j = axis == 1 ? 0 : static_cast<int32_t>((number + 0.5) * per_row);
        const double dx = i - (number - j * grid.dims[0]);
        const double dy = other - j;
        return x_ratio * dx * dx + y_ratio * dy * dy;
    }
};

// A block of columns, one after the other, and the lower envelope of one of them.
struct ColumnScratch {
    Array<int32_t> site;
    Array<double> height;  // squared offset of the site
    Array<int32_t> place;  // of the parabolas of the envelope
    Array<int32_t> held;   // their sites
    Array<double> start;   // from where each is the lowest

    explicit ColumnScratch(int32_t n)
        : site(int64_t{n} * kBlockWidth), height(int64_t{n} * kBlockWidth), place(n), held(n), start(n)
    {
    }
};

// Places along a column, from `begin` to before `end`.
struct Places {
    int32_t begin, end;
};

// Those that have sites in a block of columns, and those that these reach.
Places reached_places(const Columns& columns, const HeldBlocks& blocks, int64_t block, int32_t other)
{
    const int32_t n = columns.length();
    int32_t first = n, last = -1;
    for (int32_t y = 0; y < n; ++y)
        if (blocks.held[columns.row(y, other) * blocks.in_row + block] != 0) {
            first = std::min(first, y);
            last = y;
        }
    if (last < 0)
        return {0, 0};
    return {std::max(first - columns.reach, 0), std::min(last, n - 1 - columns.reach) + columns.reach + 1};
}

// height[y] + (x - y)^2 for each y that has a site: which is the lowest at each x?
void transform_column(const Columns& columns, Places places, int32_t* site, const double* height, ColumnScratch& s)
{
    const double* half_inverse = columns.half_inverse.data();
    int32_t* place = s.place.data();
    int32_t* held = s.held.data();
    double* start = s.start.data();
    int32_t size = 0;
    for (int32_t y = places.begin; y < places.end; ++y) {
        if (site[y] < 0 || height[y] > columns.most)
            continue;
        double from = -1;
        while (size > 0) {
            const int32_t u = place[size - 1];
            from = 0.5 * (u + y) + (height[y] - height[u]) * half_inverse[y - u];
            // A parabola that begins before the last one on the stack hides it completely. Each enters and leaves once,
            // so the time is linear.
            if (from > start[size - 1])
                break;
            from = -1;
            --size;
        }
        place[size] = y;
        held[size] = site[y];
        start[size++] = from;
    }
    if (size == 0)
        return;
    int32_t p = 0;
    for (int32_t y = places.begin; y < places.end; ++y) {
        // An exact tie stays with the earlier parabola: the same site for any number of threads.
        while (p + 1 < size && start[p + 1] < y)
            ++p;
        CLEFT_ASSERT(p < size && held[p] >= 0);
        const double along = y - place[p];
        site[y] = height[place[p]] + along * along > columns.most ? -1 : held[p];
    }
}

void transform_block(const Columns& columns, int64_t number, Array<int32_t>& nearest, HeldBlocks& blocks,
                     ColumnScratch& s)
{
    const auto other = static_cast<int32_t>(number / columns.blocks_in_row());
    const int64_t block = number % columns.blocks_in_row();
    const Places places = reached_places(columns, blocks, block, other);
    const auto i0 = static_cast<int32_t>(block) * kBlockWidth;
    const int32_t width = std::min(kBlockWidth, columns.grid.dims[0] - i0);
    const int64_t n = columns.length();
    int32_t* const corner =
        nearest.data() + (columns.axis == 1 ? columns.grid.index(i0, 0, other) : columns.grid.index(i0, other, 0));
    for (int64_t y = places.begin; y < places.end; ++y) {
        const auto first = static_cast<int32_t>(columns.first_voxel(y, other));
        for (int32_t c = 0; c < width; ++c) {
            const int32_t site = corner[y * columns.stride + c];
            s.site[c * n + y] = site;
            s.height[c * n + y] = columns.squared_offset(site - first, i0 + c, other);
        }
    }
    for (int32_t c = 0; c < width; ++c)
        transform_column(columns, places, s.site.data() + c * n, s.height.data() + c * n, s);
    for (int64_t y = places.begin; y < places.end; ++y) {
        for (int32_t c = 0; c < width; ++c)
            corner[y * columns.stride + c] = s.site[c * n + y];
        blocks.held[columns.row(y, other) * blocks.in_row + block] = 1;
    }
}

void transform_columns(const Columns& columns, Array<int32_t>& nearest, HeldBlocks& blocks, const Run& run)
{
    if (columns.length() == 1)
        return;
    // Some 16,000 voxels, as in rows_per_chunk().
    const int64_t grain = std::max<int64_t>(1, 16384 / (int64_t{columns.length()} * kBlockWidth));
    parallel_with_progress(run, columns.count(), grain, [&](int64_t, int64_t begin, int64_t end) {
        ColumnScratch scratch(columns.length());
        for (int64_t block = begin; block < end; ++block)
            transform_block(columns, block, nearest, blocks, scratch);
    });
}

// The rows by themselves, and which blocks of them have a site after that.
void transform_rows(const Grid& grid, double reach, Array<int32_t>& nearest, HeldBlocks& blocks, const Run& run)
{
    const int32_t n = grid.dims[0], steps = steps_within(reach, grid, 0);
    parallel_with_progress(run, row_count(grid), rows_per_chunk(grid), [&](int64_t, int64_t begin, int64_t end) {
        for (int64_t row = begin; row < end; ++row) {
            int32_t* const sites = nearest.data() + row * n;
            if (!has_site(sites, n))
                continue;
            transform_row(sites, static_cast<int32_t>(row * n), n, steps);
            for (int64_t b = 0; b < blocks.in_row; ++b)
                blocks.held[row * blocks.in_row + b] =
                    has_site(sites + b * kBlockWidth, std::min<int64_t>(kBlockWidth, n - b * kBlockWidth));
        }
    });
}

}  // namespace

void feature_transform(const Grid& grid, double reach, Array<int32_t>& nearest, const Run& run)
{
    Steps steps(run, {{nullptr, 1}, {nullptr, 4}, {nullptr, 5}});
    HeldBlocks blocks(grid);
    transform_rows(grid, reach, nearest, blocks, steps.next());
    // The order of the axes matters: each pass takes sites that are exact in the space of the axes before it.
    transform_columns(Columns(grid, 1, reach), nearest, blocks, steps.next());
    transform_columns(Columns(grid, 2, reach), nearest, blocks, steps.next());
}

}  // namespace cleft
