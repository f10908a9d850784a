// Tries the operations from cheap to expensive. The first that helps is taken: trying all to find the best would cost
// far more.
#include "improving/change_finder.hpp"

#include "mesh/adjacency.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/flips.hpp"

#include <algorithm>

namespace cleft
{

// Moves first, since they are cheap and change no connections.
int ChangeFinder::find(int32_t t, int step, Proposal& proposal)
{
    for (int corner = step; corner < 4; ++corner)
        if (find_move(mesh_.tet(t)[corner], proposal))
            return corner + 1;
    if (!find_new_connections(t, proposal))
        proposal.kind = Proposal::Kind::none;
    return 0;
}

bool ChangeFinder::find_move(int32_t v, Proposal& proposal)
{
    Vec3 better;
    if (!smoother_.find(v, search_.thorough, better))
        return false;
    proposal.set_move(v, better, smoother_.star().tets());
    return true;
}

bool ChangeFinder::find_new_connections(int32_t t, Proposal& proposal)
{
    Cavity& cavity = proposal.cavity;
    proposal.kind = Proposal::Kind::edge_removal;
    for (const size_t e : most_obtuse_first(mesh_, t)) {
        const auto& edge = kEdgeCorners[e];
        if (find_edge_removal(mesh_, t, edge[0], edge[1], bend_at(mesh_, search_, t, edge[0], edge[1]), cavity))
            return true;
    }
    proposal.kind = Proposal::Kind::face_removal;
    for (int corner = 0; corner < 4; ++corner)
        if (find_face_removal(mesh_, t, corner, cavity))
            return true;
    proposal.kind = Proposal::Kind::contraction;
    for (const auto& edge : kEdgeCorners)
        if (contraction_.find(mesh_, t, edge[0], edge[1], cavity) ||
            contraction_.find(mesh_, t, edge[1], edge[0], cavity))
            return true;
    // Splits come last, because they alone add points.
    if (mesh_.slot_count() >= search_.most_tets)
        return false;
    proposal.kind = Proposal::Kind::split;
    return std::any_of(std::begin(kEdgeCorners), std::end(kEdgeCorners),
                       [&](const auto& edge) { return find_split(t, edge[0], edge[1], proposal); });
}

// A point put into the edge and smoothed, if that makes the worst tetrahedron at the edge better.
bool ChangeFinder::find_split(int32_t t, int corner_a, int corner_b, Proposal& proposal)
{
    EdgeRing& ring = proposal.cavity.ring;
    mesh_.ring(t, corner_a, corner_b, ring);
    Vec3 middle;
    // The new point must lie on the tie of the materials around the edge, or the interface would get a dent.
    if (!ring.whole || !smoother_.load_middle(ring, middle))
        return false;
    const double floor = std::max(mesh_.worst(ring.tets), kLeastSine);
    const Place place = smoother_.climb(middle);
    if (!(place.worst > floor))
        return false;
    proposal.place = place.x;
    cleft::find_split(mesh_, proposal.cavity);
    return true;
}

}  // namespace cleft
