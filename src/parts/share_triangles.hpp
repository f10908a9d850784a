// The triangles of a mesh that ranks have in pieces.
#pragma once

#include "base/run.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/tet_mesh.hpp"
#include "parts/number_points.hpp"

#include <tuple>

namespace cleft
{

struct SentTriangle {
    int32_t side;  // as in PartTriangle
    std::array<int32_t, 2> regions;
    FixedArray<int64_t, 3> corners;  // numbers in the whole mesh, the least one first
    bool operator<(const SentTriangle& o) const
    {
        return std::tie(side, regions, corners) < std::tie(o.side, o.regions, o.corners);
    }
};

// Triangles inside a piece and in the sides of the box are found there. A face where a piece ends elsewhere is in the
// surface of another piece, too, or is hull: its rank compares, and then the one that owns its least corner.
class SharedTriangles
{
public:
    SharedTriangles(const BoundingBox& box, const OwnedNumbers& owned, Exchange& exchange);

    // The triangles of a piece, whose points have these numbers. All ranks call it together.
    void add(const LabelledMesh& piece, const int64_t* numbers, const Run& run);

    // Those that this rank owns, sorted. All ranks call it together, once and last.
    Array<SentTriangle> take();

private:
    // A face where a piece ends inside the box, as its tetrahedron sees it.
    struct HalfCut {
        FixedArray<int64_t, 3> corners;  // wound outward, the least number first
        int64_t least_of_tet;            // the least number of a corner
        int32_t region;

        std::array<int64_t, 3> face() const
        {
            return {corners[0], std::min(corners[1], corners[2]), std::max(corners[1], corners[2])};
        }
        bool operator<(const HalfCut& o) const
        {
            return std::make_tuple(face(), corners[1]) < std::make_tuple(o.face(), o.corners[1]);
        }
    };
    using ByRank = Array<Array<SentTriangle>>;

    // Sends the triangles among faces that two pieces have, and returns the faces that one has.
    Array<HalfCut> match(Array<HalfCut> halves, ByRank& to_owner) const;

    BoundingBox box_;
    const OwnedNumbers& owned_;
    Exchange& exchange_;
    Array<HalfCut> cut_;
    Array<SentTriangle> arrived_;
};

}  // namespace cleft
