// How one tetrahedron splits: pure combinatorics, no coordinates and no materials.
//
// Every simplex of the background may carry a centre in its interior: an edge a cut, a face whose three edges are cut a
// triple point, a tetrahedron whose six edges are cut a quadruple point (paper, section 3.1). The faces split first,
// each by a rule that depends on the face alone, so that the two tetrahedra at a face agree:
//   no cut      the face itself;
//   one cut     two triangles, from the cut to the corner opposite;
//   two cuts    the corner between them, and a quadrilateral whose diagonal leaves from the greater cut;
//   three cuts  six triangles around the triple point.
// The tetrahedron is then the fan of an apex over the triangles that do not lie in a plane with it.
//
// Lemma 1 (volume). If every face that contains the apex is a fan around it, the fan has positive volumes that add up
// to the tetrahedron's, wherever the centres lie inside their simplices: a closed tetrahedron is star-shaped around
// each of its points, and the triangles left out are exactly those that are flat with the apex.
// Lemma 2 (apex). If "greater" is one strict total order of all cuts, there is such an apex:
//   six cuts                 the quadruple point, which is inside;
//   a face with three cuts   its triple point, which lies in no other face;
//   otherwise                no three edges that are cut make a triangle, so the cut edges form a path, a star, a
//                            cycle of four, or two opposite edges: the greatest cut of a connected part. It has only
//                            faces with one cut and faces with two, where it is the greater one.
// Only cuts that are there take part: a cut that snapped to a vertex (a virtual cut of the paper) has no place in the
// stencil, and a triple point exists only among three cuts. So no cyclic choice and no Steiner point can arise.
// tests/cleaving/test_stencil.cpp proves both lemmas by enumeration.
#pragma once

#include "base/fixed_array.hpp"
#include "mesh/adjacency.hpp"

#include <cstdint>

namespace cleft
{

// Points of a split tetrahedron: 0 .. 3 its corners, then the cut of edge e (order of kEdgeCorners), the triple point
// of the face opposite corner i, and the quadruple point.
inline constexpr int kCutPoint = 4;
inline constexpr int kTriplePoint = 10;
inline constexpr int kQuadruplePoint = 14;
inline constexpr int kStencilPoints = 15;

// The corners that span the simplex in whose interior a point lies, as bits.
inline constexpr FixedArray<uint8_t, kStencilPoints> kCarrier = {1, 2, 4, 8, 3, 5, 9, 6, 10, 12, 14, 13, 11, 7, 15};

// The edge between two corners.
inline constexpr int kEdgeBetween[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

// Bit e: edge e is cut.
using CutMask = unsigned;
inline constexpr CutMask kAllCuts = 63;

// Bits of the three edges of the face opposite corner i.
inline constexpr FixedArray<CutMask, 4> kFaceCuts = {0b111000, 0b100110, 0b010101, 0b001011};

// Places of the six cuts in the total order: distinct for the edges that are cut.
using CutRanks = FixedArray<uint8_t, 6>;

// Bit i: in the face opposite corner i, which has two cuts, the one on the edge of higher number is the greater.
using Diagonals = unsigned;

Diagonals diagonals(CutMask cuts, const CutRanks& ranks);

using StencilTriangle = FixedArray<uint8_t, 3>;
using StencilTet = FixedArray<uint8_t, 4>;

// The split surface of a tetrahedron: the triangles of the face opposite corner i are first[i] .. first[i + 1],
// wound to look outward.
struct SplitSurface {
    FixedArray<StencilTriangle, 24> triangles;
    FixedArray<uint8_t, 5> first{};
};

SplitSurface split_surface(CutMask cuts, Diagonals diagonals);

// The points around which the tetrahedron may be fanned.
struct Apexes {
    FixedArray<uint8_t, kStencilPoints> point;
    int count = 0;
};

// Never empty for the diagonals of a total order (lemma 2). With six cuts the quadruple point alone: only there do all
// four materials meet. Without cuts one corner: they all give the tetrahedron itself.
Apexes apexes(CutMask cuts, const SplitSurface& surface);

// The positively oriented tetrahedra of the fan; returns their number, at most 24.
int fan(const SplitSurface& surface, int apex, FixedArray<StencilTet, 24>& out);

}  // namespace cleft
