// Attempts: an operation that may make things worse at first, the points around smoothed, and all taken back if the
// worst tetrahedron has not become better by it. Dear, so for the few that nothing else could help.
#include "improving/improver.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/flips.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// 6 edge removals, 4 face removals, 12 contractions, 6 splits.
constexpr int kOperations = 28;
// An operation may leave a tetrahedron with this share of the worst quality before it.
constexpr double kShare = 0.3;
constexpr int kSweeps = 2;
constexpr double kGain = 1e-3;

}  // namespace

bool Improver::rescue(int32_t t)
{
    const Tet corners = mesh_.tet(t);
    const double before = mesh_.quality(t);
    for (int operation = 0; operation < kOperations; ++operation) {
        if (!attempt(t, operation))
            continue;
        smooth_cavity();
        if (pays(before)) {
            ++counts_.compound;
            bad_.changed(mesh_, cavity_.created);
            for (const Move& move : moves_) {
                star_.load(mesh_, move.point);
                bad_.changed(mesh_, star_.tets());
            }
            return true;
        }
        take_back();
        // It has a new number.
        for (const int32_t back : cavity_.old_tets)
            if (mesh_.tet(back) == corners)
                t = back;
    }
    return false;
}

bool Improver::attempt(int32_t t, int operation)
{
    moves_.clear();
    if (operation < 6) {
        const auto& edge = kEdgeCorners[operation];
        return remove_edge(mesh_, t, edge[0], edge[1], bend(t, edge[0], edge[1]), cavity_, kShare);
    }
    if (operation < 10)
        return remove_face(mesh_, t, operation - 6, cavity_, kShare);
    if (operation < 22) {
        const auto& edge = kEdgeCorners[(operation - 10) / 2];
        const int gone = operation % 2;
        return contraction_.contract(mesh_, t, edge[gone], edge[1 - gone], cavity_, kShare);
    }
    const auto& edge = kEdgeCorners[operation - 22];
    return split_in_middle(t, edge[0], edge[1]);
}

bool Improver::split_in_middle(int32_t t, int corner_a, int corner_b)
{
    EdgeRing& ring = cavity_.ring;
    mesh_.ring(t, corner_a, corner_b, ring);
    star_.load(mesh_, ring);
    Vec3 middle = 0.5 * (mesh_.point(ring.a) + mesh_.point(ring.b));
    constrain(ring.tets, middle, middle, frozen_on_edge(mesh_, ring));
    if (!constraint_.project(middle) || !(star_.worst_at(middle, -1) > kShare * mesh_.worst(ring.tets)))
        return false;
    split_edge(mesh_, ring, middle, cavity_);
    home_.push_back(middle);
    return true;
}

// Moves the corners of the new tetrahedra, those of the worst ones first, until nothing helps.
void Improver::smooth_cavity()
{
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        bool moved = false;
        for (const int32_t t : cavity_.created)
            for (const int32_t v : mesh_.tet(t)) {
                if (mesh_.quality(t) >= target_)
                    break;
                const Vec3 from = mesh_.point(v);
                if (smooth(v, false)) {
                    moves_.push_back({v, from});
                    moved = true;
                }
            }
        if (!moved)
            break;
    }
}

// Everything new or moved is better than the worst was before.
bool Improver::pays(double before)
{
    const double wanted = std::min(before + kGain, target_);
    if (!(mesh_.worst(cavity_.created) >= wanted))
        return false;
    return std::all_of(moves_.begin(), moves_.end(), [&](const Move& move) {
        star_.load(mesh_, move.point);
        return star_.worst_at(mesh_.point(move.point), -1) >= wanted;
    });
}

void Improver::take_back()
{
    for (size_t i = moves_.size(); i-- > 0;)
        mesh_.move(moves_[i].point, moves_[i].from);
    counts_.moved -= static_cast<int64_t>(moves_.size());
    cavity_.undo(mesh_);
    bad_.renumbered(cavity_.old_tets);
}

}  // namespace cleft
