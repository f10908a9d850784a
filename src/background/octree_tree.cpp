// Splits the cells of an octree until they are as small as the field asks, and then until neighbours differ by one
// level.
#include "background/octree_tree.hpp"

#include "background/bcc_cell.hpp"
#include "base/collect.hpp"
#include "base/number_text.hpp"
#include "base/stage.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// A leaf may be this much larger than the least h in it: sides come in powers of two and the balance splits further;
// with this factor the mean edge comes near h.
constexpr double kSlack = 1.75;
// Where h is below the first times its least value, this is the slack: h differs a little along a thin sheet, and edges
// of 1.75 h would tear it.
// With leaves of twice the finest size from 1.14 times the least h on, an oblique sheet of two voxels had three holes.
constexpr double kThin = 1.2, kThinSlack = 1.25;
// 21 bits hold a place in a key, halves included.
constexpr int32_t kMostLevels = 20;
// What 32-bit numbers and memory hold with a margin: some twelve tetrahedra a leaf.
constexpr double kMostTets = 600e6;
constexpr double kMostCells = 60e6;

void require_few(double cells)
{
    if (cells > kMostCells)
        throw Error(CLEFT_ERROR_TOO_LARGE,
                    "the sizes ask for more than 60 million octree cells: set a greater size or "
                    "size_min");
}

double roots_in(const Int3& roots, int32_t layers) { return double(roots[0]) * double(roots[1]) * double(layers); }

void split(Octree& tree, int32_t cell)
{
    const auto first = static_cast<int32_t>(tree.cells.size());
    require_few(static_cast<double>(tree.cells.size()));
    const OctreeCell parent = tree.cells[cell];
    CLEFT_ASSERT(parent.first_child < 0);
    tree.cells[cell].first_child = first;
    for (int32_t child = 0; child < 8; ++child)
        tree.cells.push_back(
            {{2 * parent.at[0] + (child & 1), 2 * parent.at[1] + (child >> 1 & 1), 2 * parent.at[2] + (child >> 2)},
             parent.level + 1,
             -1});
    tree.levels = std::max(tree.levels, parent.level + 1);
}

// The greatest side of a root. Four along the shortest side of the box keep them nearly cubic; but where the box is so
// flat that this alone would make millions of cells, two or one do.
double greatest_root(const Vec3& extent)
{
    // A million roots take little time; what they refine to is bounded below.
    constexpr double kManyRoots = 1e6;
    double side = extent.minCoeff();
    for (const double along : {4.0, 2.0})
        if (extent.prod() * std::pow(along / side, 3) <= kManyRoots)
            return side / along;
    return side;
}

}  // namespace

// As large as the sizes and the box allow, of a side that halving brings to the least h: the finest leaves resolve what
// the field asks for, not up to kSlack less.
Int3 octree_roots(const Vec3& extent, const SizeRange& sizes)
{
    const double most = std::min(sizes.greatest * kSlack / kMeanEdge, greatest_root(extent));
    const double finest = sizes.least / kMeanEdge;
    const double side =
        most > finest ? std::ldexp(finest, std::ilogb(most / finest)) : std::min(finest, extent.minCoeff());
    Int3 roots{};
    for (int axis = 0; axis < 3; ++axis)
        roots[axis] = static_cast<int32_t>(std::clamp(std::round(extent[axis] / side), 1.0, 1e9));
    return roots;
}

namespace
{

// A spike of a user-supplied field can ask for more levels than the keys of points hold: better refused at once than
// when the tree is built. One level less than the least size needs, for the tree may miss the very tip.
void refuse_too_deep(const Octree& tree, double least_size, const Vec3& root_side)
{
    const double halvings = std::log2(kMeanEdge * std::cbrt(root_side.prod()) / (kSlack * least_size));
    const auto levels = static_cast<int32_t>(std::clamp(std::ceil(halvings) - 1, 0.0, double{kMostLevels}));
    const int64_t roots = *std::max_element(tree.roots.begin(), tree.roots.end());
    if (roots << (levels + 1) > kMostPlaces)
        throw Error(CLEFT_ERROR_TOO_LARGE, "the sizing field, whose least size is " + number_text(least_size) +
                                               ", spans too many octree levels for a box of this shape");
}

// Least h at the centre and the corners of a cell and at the centres of its octants. With a gradation below 0.7 this
// finds every smaller value in it on the way down: h at the centre is at most the least value inside plus gradation
// times half the diagonal.
double least_size(const SizingField& field, const OctreeCell& cell, const Vec3& root_side)
{
    const Vec3 side = std::ldexp(1.0, -cell.level) * root_side;
    const Vec3 low = Vec3(cell.at[0], cell.at[1], cell.at[2]).cwiseProduct(side);
    double least = field.at(low + 0.5 * side);
    for (int c = 0; c < 8; ++c) {
        const Vec3 corner(c & 1, c >> 1 & 1, c >> 2), octant = 0.5 * corner + Vec3(0.25, 0.25, 0.25);
        least = std::min({least, field.at(low + corner.cwiseProduct(side)), field.at(low + octant.cwiseProduct(side))});
    }
    return least;
}

// A level at a time: whether a cell is split follows from the field alone, and its children join the end of the list.
void refine(Octree& tree, const SizingField& field, double least_of_all, const Vec3& root_side, const Run& run)
{
    constexpr int64_t kCellsAtOnce = 256;  // each reads seventeen sizes
    const double thin = kThin * least_of_all;
    const auto is_too_large = [&](const OctreeCell& cell) {
        const double edge = kMeanEdge * std::ldexp(std::cbrt(root_side.prod()), -cell.level);
        const double h = least_size(field, cell, root_side);
        return cell.level < kMostLevels && edge > (h < thin ? kThinSlack : kSlack) * h;
    };
    Array<uint8_t> splits;
    for (int64_t first = 0, end = tree.cells.count(); first < end; first += splits.count(), end = tree.cells.count()) {
        run.report(static_cast<double>(first) / static_cast<double>(end));
        splits.assign(to_size(end - first), 0);
        parallel_for(run, splits.count(), kCellsAtOnce, [&](int64_t begin, int64_t behind) {
            for (int64_t i = begin; i < behind; ++i)
                splits[i] = is_too_large(tree.cells[first + i]) ? 1 : 0;
        });
        for (int64_t i = 0; i < splits.count(); ++i)
            if (splits[i])
                split(tree, static_cast<int32_t>(first + i));
    }
}

// visit(place) for each place next to that of a cell over a face or an edge, in the grid of its level.
template <class Visit>
void for_each_beside(const OctreeCell& cell, const Visit& visit)
{
    for (int d = 0; d < 27; ++d) {
        const Int3 step = {d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
        const int reach = std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]);
        if (reach == 1 || reach == 2)
            visit(Int3{cell.at[0] + step[0], cell.at[1] + step[1], cell.at[2] + step[2]});
    }
}

// What is at a place beside a cell, if it is more than one level coarser; else -1.
int32_t too_coarse_at(const Octree& tree, const Int3& place, int32_t level)
{
    const int32_t other = tree.find(place, level);
    return other >= 0 && tree.cells[other].level < level - 1 ? other : -1;
}

// Leaves that have something too coarse beside them. All others never will have: cells only get finer.
Array<int32_t> unbalanced_leaves(const Octree& tree, const Run& run)
{
    constexpr int64_t kCellsAtOnce = 1024;  // each looks at eighteen places
    return collect<int32_t>(run, tree.cells.count(), kCellsAtOnce,
                            [&](int64_t begin, int64_t end, Array<int32_t>& leaves) {
                                for (auto c = static_cast<int32_t>(begin); c < end; ++c) {
                                    const OctreeCell& cell = tree.cells[c];
                                    if (!tree.is_leaf(c) || cell.level <= 1)
                                        continue;
                                    bool is_balanced = true;
                                    for_each_beside(cell, [&](const Int3& place) {
                                        is_balanced = is_balanced && too_coarse_at(tree, place, cell.level) < 0;
                                    });
                                    if (!is_balanced)
                                        leaves.push_back(c);
                                }
                            });
}

// Splits what is more than one level coarser than a neighbour over a face or an edge. Cells made on the way are looked
// at in their turn.
// The order of the queue follows from the cells alone, so the numbers of the cells do too.
void balance(Octree& tree, const Run& run)
{
    Array<int32_t> queue = unbalanced_leaves(tree, run);
    for (size_t q = 0; q < queue.size(); ++q) {
        run.check_at(q);
        const OctreeCell cell = tree.cells[queue[q]];
        for_each_beside(cell, [&](const Int3& place) {
            for (int32_t other = too_coarse_at(tree, place, cell.level); other >= 0;
                 other = too_coarse_at(tree, place, cell.level)) {
                split(tree, other);
                const int32_t first = tree.cells[other].first_child;
                if (tree.cells[first].level > 1)
                    for (int32_t child = first; child < first + 8; ++child)
                        queue.push_back(child);
            }
        });
    }
}

}  // namespace

int32_t Octree::find(const Int3& at, int32_t level) const
{
    Int3 root{};
    for (int axis = 0; axis < 3; ++axis) {
        root[axis] = at[axis] >> level;
        if (at[axis] < 0 || root[axis] >= roots[axis])
            return -1;
    }
    if (!layers.has(root[2]))
        return -1;
    int32_t cell = root[0] + roots[0] * (root[1] + roots[1] * (root[2] - layers.first));
    for (int32_t l = level - 1; l >= 0 && !is_leaf(cell); --l) {
        const int32_t child = (at[0] >> l & 1) + 2 * (at[1] >> l & 1) + 4 * (at[2] >> l & 1);
        cell = cells[cell].first_child + child;
    }
    return cell;
}

double rough_octree_tets(const Vec3& extent, const SizeRange& sizes, double particle_tets)
{
    constexpr double kTetsACell = 12;  // of body-centred cubic cells
    const Int3 roots = octree_roots(extent, sizes);
    return std::max(kTetsACell * roots_in(roots, roots[2]), kTetsOverParticles * particle_tets);
}

namespace
{

// `sizes`: the range of the field.
double rough_tets(const SizingField& field, const SizeRange& sizes)
{
    const Vec3 extent = field.grid.extent();
    const Int3 roots = octree_roots(extent, sizes);
    require_few(roots_in(roots, roots[2]));
    return rough_octree_tets(extent, sizes, expected_particle_tets(field));
}

void refuse_too_many(const SizingField& field, const SizeRange& sizes)
{
    const double tets = rough_tets(field, sizes);
    if (tets > kMostTets)
        throw Error(CLEFT_ERROR_TOO_LARGE, "the sizes ask for an octree of about " + count_text(tets / 1e6) +
                                               " million tetrahedra, but it can have 600 million at most: set a "
                                               "greater size or size_min, or a number of tetrahedra by tets");
}

}  // namespace

double rough_octree_tets(const SizingField& field) { return rough_tets(field, field.range()); }

Octree build_octree(const SizingField& field, const Run& run)
{
    const SizeRange sizes = field.range();
    refuse_too_many(field, sizes);
    return build_octree_part(field, sizes, {0, octree_roots(field.grid.extent(), sizes)[2]}, run);
}

Octree build_octree_part(const SizingField& field, const SizeRange& sizes, Planes layers, const Run& run)
{
    const Vec3 extent = field.grid.extent();
    Octree tree;
    tree.roots = octree_roots(extent, sizes);
    tree.layers = layers;
    require_few(roots_in(tree.roots, layers.count));
    for (int32_t k = layers.first; k < layers.end(); ++k)
        for (int32_t j = 0; j < tree.roots[1]; ++j)
            for (int32_t i = 0; i < tree.roots[0]; ++i)
                tree.cells.push_back({{i, j, k}, 0, -1});
    const Vec3 root_side = extent.cwiseQuotient(Vec3(tree.roots[0], tree.roots[1], tree.roots[2]));
    refuse_too_deep(tree, sizes.least, root_side);
    Steps steps(run, {{"background: octree", 3}, {"background: balancing the octree", 1}});
    refine(tree, field, sizes.least, root_side, steps.next());
    balance(tree, steps.next());
    return tree;
}

}  // namespace cleft
