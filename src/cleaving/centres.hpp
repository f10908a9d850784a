// The background with the centres of its simplices: the state that snapping changes and splitting reads.
//
// Only what an interface crosses takes memory: vertices carry sets of materials; edges whose ends have disjoint sets
// are cut; tables of faces and tetrahedra hold those with cuts alone. Sets only grow, so cuts only vanish, and the
// tables made at the start hold all that can ever be.
#pragma once

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "cleaving/sample_store.hpp"
#include "cleaving/stencil_table.hpp"
#include "cleaving/vertex_metrics.hpp"
#include "volume/tie.hpp"

#include <memory>

namespace cleft
{

// An edge that was cut at the start, from its lower vertex to its higher one.
// It has one direction and one t, so all tetrahedra at the edge get the same point, to the last bit.
struct CutEdge {
    int32_t lower, upper;
    double t;     // the cut is at lower + t (upper - lower)
    bool is_cut;  // false once an end has snapped onto the interface
};

// A face whose three edges were cut at the start. It has a triple point while all three still are.
struct TripleFace {
    FixedArray<int32_t, 3> edges;
};

// A tetrahedron with at least one edge that was cut at the start; -1 where there is no entry.
struct MixedTet {
    int32_t tet;
    FixedArray<int32_t, 6> edges;  // in CutEdge, order of kEdgeCorners
    FixedArray<int32_t, 4> faces;  // in TripleFace, opposite corner i
};

// How a mixed tetrahedron splits: the fan whose worst tetrahedron is best.
struct Fan {
    double cost = 0;  // of its tetrahedra, see shape_cost
    uint16_t stencil = 0;
};

struct Centres {
    const Volume& volume;
    const Array<Tet>& tets;
    Array<Vec3> points;  // of the vertices; snapping moves them
    Array<MaterialSet> materials;
    SampleStore samples;

    Array<CutEdge> edges;
    Array<TripleFace> faces;
    Array<MixedTet> mixed;
    Array<int32_t> mixed_of;  // by tetrahedron, or -1
    StencilTable stencils;
    Array<Fan> fans;  // of the mixed tetrahedra, where all centres are as they were when it was chosen

    // By tetrahedron whose corners all have the same two materials: the one that it had before; else kNoMaterial.
    // Sixteen bits suffice, since a volume has at most 65,535 materials.
    Array<uint16_t> kept;
    static constexpr uint16_t kNoMaterial = 0xffff;

    // By vertex: the interfaces at it may be pinched, since it or one next to it snapped unseen by PinchCheck.
    Array<uint8_t> doubtful{};

    // Lengths and shapes are measured by these.
    VertexMetrics metrics{};

    const Vec3& point(int32_t v) const { return points[v]; }
    const MaterialSet& materials_of(int32_t v) const { return materials[v]; }
    const Tet& corners(int32_t tet) const { return tets[tet]; }
    bool is_cut(int32_t edge) const { return edge >= 0 && edges[edge].is_cut; }
    bool has_triple(const TripleFace& f) const
    {
        return is_cut(f.edges[0]) && is_cut(f.edges[1]) && is_cut(f.edges[2]);
    }
    CutMask cuts(const MixedTet& m) const;
    bool has_quadruple(const MixedTet& m) const;

    // Triple and quadruple points are the means of the cuts around them: inside whatever the cuts are, and near the
    // tie where all cuts are. Written as corner + sum of shares of sides, so that a coordinate that all corners share
    // comes out exactly: centres of box faces lie in their face to the last bit.
    Vec3 cut_point(const CutEdge& e) const { return point(e.lower) + e.t * (point(e.upper) - point(e.lower)); }
    Vec3 triple_point(const TripleFace& f) const;
    Vec3 quadruple_point(const MixedTet& m) const;

    // Finds a cut anew, after an end has moved or changed its materials.
    void place_cut(CutEdge& e, Samples& scratch) const;
    // The same if its ends still have no material in common; else it is a cut no more.
    void renew_cut(CutEdge& e, Samples& scratch) const
    {
        e.is_cut = disjoint(materials_of(e.lower), materials_of(e.upper));
        if (e.is_cut)
            place_cut(e, scratch);
    }
};

}  // namespace cleft
