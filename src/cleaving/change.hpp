// Changes of the materials of a few tetrahedra, which may mend a pinched interface.
#pragma once

#include "base/array.hpp"
#include "cleaving/link.hpp"
#include "mesh/point_stars.hpp"

namespace cleft
{

// Tetrahedra of one material, and the one that they may get.
struct Change {
    Array<int32_t> tets;
    Material from, to;
    double volume;
};

// At a point with defects, whose link this is: single tetrahedra, sectors around pinched edges, and pieces at a pinched
// point. The least volume first.
Array<Change> changes_at(const LabelledMesh& mesh, const PointStars::Range& star, const Link& link);

// What a change breaks, the worse the greater: it cuts the one material or joins the other, does both, or takes a whole
// piece of the one or makes one of the other.
enum class Harm { none, cuts_or_joins, both, adds_or_loses };

class HarmCheck
{
public:
    HarmCheck(const LabelledMesh& mesh, const PointStars& stars) : mesh_(mesh), stars_(stars), met_(mesh.tets.size(), 0)
    {
    }

    // Judged from near by: pieces that hang together far away only are two.
    // A way around that is longer than the search counts as none, so the answer may be too bad, never too good.
    Harm harm(const Change& change);

private:
    Array<int32_t> touching(const Change& change, Material material) const;
    bool are_connected(const Array<int32_t>& tets, const Change& change);
    int32_t neighbour(int32_t tet, size_t corner) const;

    const LabelledMesh& mesh_;
    const PointStars& stars_;
    Array<int32_t> met_;  // by tetrahedron: in which search
    int32_t search_ = 0;
    Array<int32_t> queue_;
};

}  // namespace cleft
