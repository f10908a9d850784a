// Finds splits of long edges and contractions of short ones.
#include "remeshing/length_changes.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"
#include "remeshing/edge_length.hpp"
#include "remeshing/edge_split.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// No split makes an angle of less than a degree: where a metric jumps from voxel to voxel, splits upon splits would end
// in tetrahedra whose sign is rounding.
constexpr double kLeastSplit = 0.02;

}  // namespace

void LengthChanges::find_split(int32_t t, Proposal& proposal)
{
    if (mesh_.slot_count() >= goal_.most_tets)
        return;
    const auto lengths = edge_lengths(mesh_, t);
    const auto& edge = kEdgeCorners[std::max_element(lengths.begin(), lengths.end()) - lengths.begin()];
    EdgeRing& ring = proposal.cavity.ring;
    mesh_.ring(t, edge[0], edge[1], ring);
    if (!ring.whole)
        return;
    const Vec3 &a = mesh_.point(ring.a), &b = mesh_.point(ring.b);
    proposal.place = a + middle_of_length(mesh_, ring.a, ring.b) * (b - a);
    star_.load(mesh_, ring);
    if (!(star_.worst_at(proposal.place, kLeastSplit) > kLeastSplit))
        return;
    cleft::find_split(mesh_, proposal.cavity);
    if (are_positive(proposal))
        proposal.kind = Proposal::Kind::split;
}

// What is nearly flat may get another sign by the rounding of the star's frame.
bool LengthChanges::are_positive(const Proposal& proposal) const
{
    const auto place_of = [&](int32_t v) { return v == kNewPoint ? proposal.place : mesh_.point(v); };
    return std::all_of(proposal.cavity.new_tets.begin(), proposal.cavity.new_tets.end(), [&](const Tet& t) {
        return orient_sign(place_of(t[0]), place_of(t[1]), place_of(t[2]), place_of(t[3])) > 0;
    });
}

void LengthChanges::find_contraction(int32_t t, Proposal& proposal)
{
    const auto lengths = edge_lengths(mesh_, t);
    std::array<size_t, 6> edges{0, 1, 2, 3, 4, 5};
    std::stable_sort(edges.begin(), edges.end(), [&](size_t e, size_t f) { return lengths[e] < lengths[f]; });
    for (const size_t e : edges) {
        if (lengths[e] >= goal_.shortest)
            return;
        for (const int end : {0, 1}) {
            const int gone = kEdgeCorners[e][end], kept = kEdgeCorners[e][1 - end];
            if (makes_no_long_edge(mesh_.tet(t)[gone], mesh_.tet(t)[kept]) &&
                contraction_.find(mesh_, t, gone, kept, proposal.cavity, 1, goal_.enough)) {
                proposal.kind = Proposal::Kind::contraction;
                return;
            }
        }
    }
}

// Or the edges that it makes would be split in the next pass.
bool LengthChanges::makes_no_long_edge(int32_t gone, int32_t kept)
{
    for (const int32_t t : mesh_.star(gone))
        for (const int32_t v : mesh_.tet(t))
            if (v != gone && v != kept && edge_length(mesh_, kept, v) > goal_.longest_made)
                return false;
    return true;
}

double longest_edge(const LocalMesh& mesh, int32_t t)
{
    const auto lengths = edge_lengths(mesh, t);
    return *std::max_element(lengths.begin(), lengths.end());
}

double shortest_edge(const LocalMesh& mesh, int32_t t)
{
    const auto lengths = edge_lengths(mesh, t);
    return *std::min_element(lengths.begin(), lengths.end());
}

}  // namespace cleft
