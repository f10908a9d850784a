// From a balanced octree to tetrahedra (after Labelle and Shewchuk, isosurface stuffing, section 4).
//
// Points are the corners and the centres of leaves. Every face of a leaf that is not split by finer leaves behind it is
// a facet, met in one of three ways:
//  - behind it a leaf of the same size: the tetrahedra around the line between the two centres, one for each side of
//    the facet, or two for a side that finer leaves have split in the middle;
//  - behind it a leaf of twice the size: the square is cut along the diagonal that meets the middle of the larger face,
//    and each half is joined to both centres. Its sides have no point in their middle: a leaf of half the size there
//    would touch the larger leaf over a face or an edge, which the balance of the tree forbids;
//  - a wall behind it: the square is cut in two, or around its middle if finer leaves have split its sides, and
//    joined to the one centre.
#include "background/octree.hpp"

#include "background/octree_tree.hpp"
#include "base/collect.hpp"
#include "base/parallel.hpp"
#include "base/sorted_set.hpp"
#include "base/stage.hpp"

#include <algorithm>
#include <atomic>

namespace cleft
{

namespace
{

// Cells that a thread meshes at a time. The number changes the time alone.
constexpr int64_t kCellsMeshed = 4096;

// Corners live on the grid of half the deepest side, so that middles of sides are whole numbers too.
class Points
{
public:
    Points(const Octree& tree, const Vec3& extent, const Run& run) : tree_(tree), extent_(extent)
    {
        for (int axis = 0; axis < 3; ++axis)
            fine_[axis] = int64_t{tree.roots[axis]} << (tree.levels + 1);
        // A sorted list instead of a hash: the order of the points is that of their places, and a search needs no more
        // memory.
        const auto list = [&](int64_t begin, int64_t end, Array<uint64_t>& keys) {
            for (int64_t i = begin; i < end; ++i)
                if (tree.cells[i].first_child < 0)
                    for (int c = 0; c < 8; ++c)
                        keys.push_back(key(corner(tree.cells[i], c)));
        };
        keys_ = sorted_set<uint64_t>(run, tree.cells.count(), kCellsMeshed, list);
    }

    FixedArray<int64_t, 3> corner(const OctreeCell& cell, int c) const
    {
        const int shift = tree_.levels + 1 - cell.level;
        return {int64_t{cell.at[0] + (c & 1)} << shift, int64_t{cell.at[1] + (c >> 1 & 1)} << shift,
                int64_t{cell.at[2] + (c >> 2)} << shift};
    }

    // The number of the point at a fine place, or -1.
    int32_t number(const FixedArray<int64_t, 3>& at) const
    {
        const uint64_t k = key(at);
        const auto found = std::lower_bound(keys_.begin(), keys_.end(), k);
        return found != keys_.end() && *found == k ? static_cast<int32_t>(found - keys_.begin()) : -1;
    }

    int32_t count() const { return static_cast<int32_t>(keys_.size()); }

    Vec3 position(const FixedArray<int64_t, 3>& at) const
    {
        Vec3 x;
        for (int axis = 0; axis < 3; ++axis) {
            const double extent = extent_[axis];
            x[axis] = at[axis] == fine_[axis]
                          ? extent
                          : static_cast<double>(at[axis]) * (extent / static_cast<double>(fine_[axis]));
        }
        return x;
    }

    Array<Vec3> positions() const
    {
        Array<Vec3> out;
        out.reserve(keys_.size());
        for (int32_t p = 0; p < count(); ++p)
            out.push_back(position(place(p)));
        return out;
    }

    // The fine place of a point.
    FixedArray<int64_t, 3> place(int32_t point) const
    {
        const uint64_t k = keys_[point];
        return {static_cast<int64_t>(k & kMask), static_cast<int64_t>(k >> 21 & kMask), static_cast<int64_t>(k >> 42)};
    }

    // Three places of 21 bits make one key.
    bool fits() const { return std::max({fine_[0], fine_[1], fine_[2]}) <= kMostPlaces; }

private:
    static constexpr uint64_t kMask = kMostPlaces;
    static uint64_t key(const FixedArray<int64_t, 3>& at)
    {
        return static_cast<uint64_t>(at[0]) | static_cast<uint64_t>(at[1]) << 21 | static_cast<uint64_t>(at[2]) << 42;
    }

    const Octree& tree_;
    Vec3 extent_;
    FixedArray<int64_t, 3> fine_{};
    Array<uint64_t> keys_;
};

// A face of a leaf: its corners in order around it, the normal looking along the axis, and the points in the middles of
// its sides (-1 where there is none).
struct Facet {
    FixedArray<int32_t, 4> corner{};
    FixedArray<int32_t, 4> middle{};  // middle[i] lies between corner[i] and corner[i + 1]
};

// What some leaves become. The corner ~i of a tetrahedron is the i-th of the hubs.
struct Part {
    Array<Tet> tets;
    Array<Vec3> hubs;  // in the middle of faces at walls
};

class Mesher
{
public:
    Mesher(const Octree& tree, const Points& points, const Array<int32_t>& centre, Part& part)
        : tree_(tree), points_(points), centre_(centre), hubs_(part.hubs), tets_(part.tets)
    {
    }

    void mesh_leaf(int32_t leaf)
    {
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side)
                mesh_face(leaf, axis, side);
    }

private:
    void mesh_face(int32_t leaf, int axis, int side)
    {
        const OctreeCell& cell = tree_.cells[leaf];
        Int3 behind = cell.at;
        behind[axis] += 2 * side - 1;
        const int32_t other = tree_.find(behind, cell.level);
        if (other < 0) {
            join_wall(centre_[leaf], outward(facet(cell, axis, side), side));
        } else if (tree_.is_leaf(other)) {
            const int32_t own = centre_[leaf], far = centre_[other];
            CLEFT_ASSERT(cell.level - tree_.cells[other].level <= 1);
            // Each pair of leaves is met from both sides. The finer one writes, and of equal ones the lower.
            if (tree_.cells[other].level < cell.level)
                join_coarser(own, far, outward(facet(cell, axis, side), side), cell, axis);
            else if (side == 1)
                join_equal(own, far, facet(cell, axis, side));
        }
    }

    Facet facet(const OctreeCell& cell, int axis, int side) const
    {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        FixedArray<int64_t, 3> at[4];
        Facet out;
        for (size_t c = 0; c < 4; ++c) {
            const int along_u = c == 1 || c == 2, along_v = c >= 2;
            at[c] = points_.corner(cell, side << axis | along_u << u | along_v << v);
            out.corner[c] = points_.number(at[c]);
            CLEFT_ASSERT(out.corner[c] >= 0);
        }
        for (size_t c = 0; c < 4; ++c) {
            const auto& a = at[c];
            const auto& b = at[(c + 1) % 4];
            out.middle[c] = points_.number({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
        }
        return out;
    }

    // The facet with its normal looking out of the cell.
    static Facet outward(const Facet& f, int side)
    {
        if (side == 1)
            return f;
        return {{f.corner[0], f.corner[3], f.corner[2], f.corner[1]},
                {f.middle[3], f.middle[2], f.middle[1], f.middle[0]}};
    }

    void join_equal(int32_t low, int32_t high, const Facet& f)
    {
        for (size_t c = 0; c < 4; ++c) {
            const int32_t a = f.corner[c], b = f.corner[(c + 1) % 4];
            if (f.middle[c] < 0) {
                tets_.push_back({low, a, b, high});
            } else {
                tets_.push_back({low, a, f.middle[c], high});
                tets_.push_back({low, f.middle[c], b, high});
            }
        }
    }

    // The corner of the facet in the middle of the larger face is the one at odd places across the axis.
    void join_coarser(int32_t own, int32_t far, const Facet& f, const OctreeCell& cell, int axis)
    {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const int odd_u = 1 - (cell.at[u] & 1), odd_v = 1 - (cell.at[v] & 1);
        const FixedArray<int64_t, 3> low = points_.corner(cell, 0), high = points_.corner(cell, 7);
        int start = -1;
        for (int c = 0; c < 4; ++c) {
            const auto at = points_.place(f.corner[c]);
            if (at[u] == (odd_u ? high : low)[u] && at[v] == (odd_v ? high : low)[v])
                start = c;
        }
        CLEFT_ASSERT(start >= 0);
        for (int half = 1; half < 3; ++half) {
            const int32_t a = f.corner[start], b = f.corner[(start + half) % 4], c = f.corner[(start + half + 1) % 4];
            tets_.push_back({own, a, b, c});
            tets_.push_back({far, a, c, b});
        }
    }

    // Two halves; or, where a side has a point in its middle, a fan around a new point in the middle of the square.
    void join_wall(int32_t own, const Facet& f)
    {
        const bool split = std::any_of(f.middle.begin(), f.middle.end(), [](int32_t m) { return m >= 0; });
        if (!split) {
            tets_.push_back({own, f.corner[0], f.corner[1], f.corner[2]});
            tets_.push_back({own, f.corner[0], f.corner[2], f.corner[3]});
            return;
        }
        const auto hub = ~static_cast<int32_t>(hubs_.size());
        hubs_.push_back(wall_middle(f));
        for (size_t c = 0; c < 4; ++c) {
            const int32_t a = f.corner[c], b = f.corner[(c + 1) % 4];
            if (f.middle[c] >= 0) {
                tets_.push_back({own, hub, a, f.middle[c]});
                tets_.push_back({own, hub, f.middle[c], b});
            } else {
                tets_.push_back({own, hub, a, b});
            }
        }
    }

    // Exactly in the wall, since fine places are whole numbers.
    Vec3 wall_middle(const Facet& f) const
    {
        const auto a = points_.place(f.corner[0]), b = points_.place(f.corner[2]);
        return points_.position({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2});
    }

    const Octree& tree_;
    const Points& points_;
    const Array<int32_t>& centre_;
    Array<Vec3>& hubs_;
    Array<Tet>& tets_;
};

// By cell: the number of the point in the centre of a leaf, which goes to `mesh`.
Array<int32_t> add_centres(const Octree& tree, const Points& points, TetMesh& mesh)
{
    Array<int32_t> centre(tree.cells.size(), -1);
    for (size_t c = 0; c < tree.cells.size(); ++c)
        if (tree.cells[c].first_child < 0) {
            if (mesh.points.count() >= INT32_MAX)
                throw Error(CLEFT_ERROR_TOO_LARGE, "the octree has more than 2147483647 points");
            centre[c] = static_cast<int32_t>(mesh.points.size());
            const auto low = points.corner(tree.cells[c], 0), high = points.corner(tree.cells[c], 7);
            mesh.points.push_back(
                points.position({(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2}));
        }
    return centre;
}

// Part after part, so that the number of threads does not show.
void add_parts(Array<Part>& parts, TetMesh& mesh, const Run& run)
{
    for (Part& part : parts) {
        const auto first_hub = static_cast<int32_t>(mesh.points.size());
        mesh.points.insert(mesh.points.end(), part.hubs.begin(), part.hubs.end());
        if (part.hubs.empty())
            continue;
        for (Tet& tet : part.tets)
            for (int32_t& v : tet)
                v = v < 0 ? first_hub + ~v : v;
    }
    mesh.tets = joined<Tet>(run, parts, &Part::tets);
}

TetMesh mesh_of(const Octree& tree, const Vec3& extent, const Run& of_cells)
{
    const Points points(tree, extent, of_cells);
    if (!points.fits())
        throw Error(CLEFT_ERROR_TOO_LARGE, "the sizing field spans too many octree levels for a box of this shape");
    TetMesh mesh;
    mesh.points = points.positions();
    const Array<int32_t> centre = add_centres(tree, points, mesh);
    Array<Part> parts(chunk_count(tree.cells.count(), kCellsMeshed));
    parallel_chunks(of_cells, tree.cells.count(), kCellsMeshed, [&](int64_t chunk, int64_t begin, int64_t end) {
        Mesher mesher(tree, points, centre, parts[chunk]);
        for (int64_t c = begin; c < end; ++c)
            if (tree.cells[c].first_child < 0)
                mesher.mesh_leaf(static_cast<int32_t>(c));
    });
    add_parts(parts, mesh, of_cells);
    return mesh;
}

// Of the layers that tetrahedra between two places along the last axis come from. A tetrahedron is in two leaves at
// most, and these depend on what is less than a root away: halving doubles with each leaf from the least one on, so
// that leaves of a root's side are a root's side away. One layer more is to spare.
Planes layers_around(int32_t layers, double extent, double low, double high)
{
    constexpr int32_t kLayersAround = 3;
    const double side = extent / layers;
    const auto layer_of = [&](double z) { return std::clamp(static_cast<int32_t>(z / side), 0, layers - 1); };
    const int32_t first = std::max(0, layer_of(low) - kLayersAround);
    return {first, std::min(layers, layer_of(high) + 1 + kLayersAround) - first};
}

}  // namespace

TetMesh octree_background(const SizingField& field, const Run& run)
{
    Steps steps(run, {{nullptr, 1}, {"background: cells", 1}});
    const Octree tree = build_octree(field, steps.next());
    return mesh_of(tree, field.grid.extent(), steps.next());
}

Planes octree_slab_planes(const Grid& grid, const SizeRange& sizes, double low, double high)
{
    const Vec3 extent = grid.extent();
    const int32_t all = octree_roots(extent, sizes)[2];
    const Planes layers = layers_around(all, extent[2], low, high);
    // Values are read between the centres of planes: one plane more on either side, and one for the rounding.
    const double planes_a_layer = static_cast<double>(grid.dims[2]) / all;
    const int32_t first = std::max(0, static_cast<int32_t>(layers.first * planes_a_layer) - 2);
    return {first, std::min(grid.dims[2], static_cast<int32_t>(layers.end() * planes_a_layer) + 3) - first};
}

TetMesh octree_slab(const SizingField& field, const SizeRange& sizes, double low, double high, const Run& run)
{
    Steps steps(run, {{nullptr, 1}, {"background: cells", 1}});
    const Vec3 extent = field.grid.extent();
    const Planes layers = layers_around(octree_roots(extent, sizes)[2], extent[2], low, high);
    const Octree tree = build_octree_part(field, sizes, layers, steps.next());
    return mesh_of(tree, extent, steps.next());
}

// A face is counted where the finer of the two leaves, or one of two equal ones, would write its tetrahedra.
int64_t tets_of_leaf(const Octree& tree, const OctreeCell& leaf)
{
    // What the mesher writes for a face without split sides. Faces with split sides have more, and are counted as if
    // they had none.
    constexpr int64_t kAtWall = 2, kBetweenEqual = 4, kFromFiner = 4;
    int64_t tets = 0;
    for (int face = 0; face < 6; ++face) {
        Int3 behind = leaf.at;
        behind[face / 2] += face % 2 == 1 ? 1 : -1;
        const int32_t other = tree.find(behind, leaf.level);
        if (other < 0)
            tets += kAtWall;
        else if (tree.is_leaf(other) && tree.cells[other].level < leaf.level)
            tets += kFromFiner;
        else if (tree.is_leaf(other) && face % 2 == 1)
            tets += kBetweenEqual;
    }
    return tets;
}

int64_t octree_tets(const SizingField& field, const Run& run)
{
    const Octree tree = build_octree(field, run);
    std::atomic<int64_t> tets{0};  // whole numbers have the same sum in any order
    parallel_for(run, tree.cells.count(), kCellsMeshed, [&](int64_t begin, int64_t end) {
        int64_t of_chunk = 0;
        for (int64_t c = begin; c < end; ++c)
            of_chunk += tree.cells[c].first_child < 0 ? tets_of_leaf(tree, tree.cells[c]) : 0;
        tets += of_chunk;
    });
    return tets;
}

double octree_tets_near_limit(const SizingField& field, double limit, const Run& run)
{
    // The rough number is off by less than that for sizes of features. A tree takes as long as some percent of a mesh.
    constexpr double kFar = 4;
    const double rough = rough_octree_tets(field);
    return rough > kFar * limit || kFar * rough < limit ? rough : static_cast<double>(octree_tets(field, run));
}

}  // namespace cleft
