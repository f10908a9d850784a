// The balanced octree under the graded background.
#pragma once

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/run.hpp"
#include "sizing/sizing_field.hpp"

#include <cstdint>

namespace cleft
{

using Int3 = FixedArray<int32_t, 3>;

// Places along an axis at the finest level, halves counted: three of them make one 64-bit key.
inline constexpr int64_t kMostPlaces = (int64_t{1} << 21) - 1;

// A cell: place `at` in the grid of its level, where level 0 are the roots and each level halves the side.
struct OctreeCell {
    Int3 at;
    int32_t level;
    int32_t first_child;  // -1: a leaf
};

struct Octree {
    Int3 roots{};             // number of roots along each axis
    Planes layers;            // of roots across the last axis that are there; they are the first cells
    int32_t levels = 0;       // depth of the deepest cell
    Array<OctreeCell> cells;  // children of a cell are eight in a row, x fastest

    bool is_leaf(int32_t cell) const { return cells[cell].first_child < 0; }
    // The leaf or inner cell of at most `level` that covers place `at` of that level; -1 outside the box.
    int32_t find(const Int3& at, int32_t level) const;
};

// Tetrahedra of an octree over those of particles of the same field, mostly. Around spikes of a user-supplied field
// there are more: there the number of cells is the bound.
constexpr double kTetsOverParticles = 1.5;

// The tetrahedra that an octree mostly has, without building it. The same from the range of the sizes, and from the
// number that particles would need for them.
double rough_octree_tets(const SizingField& field);
double rough_octree_tets(const Vec3& extent, const SizeRange& sizes, double particle_tets);

// The roots of a box for sizes of that range.
Int3 octree_roots(const Vec3& extent, const SizeRange& sizes);

// Splits cells until a leaf's mean edge is about h, then until leaves that share a face or an edge differ by at most
// one level.
Octree build_octree(const SizingField& field, const Run& run);

// A part of the tree of a large field: some layers of roots, for which `field` has the planes. `sizes` are those of the
// whole field. Leaves of the outermost layers may be coarser than in the whole tree, since what is behind them is not
// seen.
Octree build_octree_part(const SizingField& field, const SizeRange& sizes, Planes layers, const Run& run);

}  // namespace cleft
