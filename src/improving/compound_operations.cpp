// Each attempt is an operation, a round of smoothing, and a verdict.
#include "improving/compound_operations.hpp"

#include "mesh/adjacency.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/flips.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// 6 edge removals, 4 face removals, 12 contractions, 6 splits.
constexpr int kOperations = 28;
// An operation may leave a tetrahedron with this share of the worst quality before it.
// A greater share would refuse operations that smoothing could still make good. A smaller one would start attempts that
// smoothing can hardly save.
constexpr double kShare = 0.3;
// A new tetrahedron that smoothing cannot bring to this share of it never gets better than it, or hardly ever: with
// those the attempt is given up. That saves half the time, and costs 2 % of the attempts that would help.
constexpr double kHopeful = 0.95;
// At 20 degrees this is 0.06 degrees. A smaller gain would not be worth an attempt, the most expensive work of
// improving.
constexpr double kLeastGain = 1e-3;

// What an operation does follows from its kind and the points it is about: the tetrahedra at an edge have it in common.
std::array<int32_t, 4> subject_of(int operation, const Tet& place)
{
    const auto edge = [&](int kind, int number) {
        const int32_t a = place[kEdgeCorners[number][0]], b = place[kEdgeCorners[number][1]];
        return std::array<int32_t, 4>{kind, std::min(a, b), std::max(a, b), -1};
    };
    if (operation < 6)
        return edge(0, operation);
    if (operation >= 22)
        return edge(1, operation - 22);
    if (operation >= 10) {
        const auto& ends = kEdgeCorners[(operation - 10) / 2];
        const int gone = operation % 2;
        return {2, place[ends[gone]], place[ends[1 - gone]], -1};
    }
    std::array<int32_t, 4> face{3, 0, 0, 0};
    for (size_t k = 0; k < 3; ++k)
        face[k + 1] = place[kFaceCorners[operation - 6][k]];
    std::sort(face.begin() + 1, face.end());
    return face;
}

}  // namespace

bool CompoundOperations::improve(int32_t t, const Search& search, double target)
{
    search_ = search;
    target_ = target;
    smoother_.aim_at(target, search.tolerance);
    const Tet bad = mesh_.tet(t);
    const double before = mesh_.quality(t);
    tried_.clear();
    if (improve_at(bad, bad, before))
        return true;
    if (!search_.wide)
        return false;
    const Array<Tet> around = tets_around(bad);
    return std::any_of(around.begin(), around.end(), [&](const Tet& place) { return improve_at(place, bad, before); });
}

// Tries every operation at a tetrahedron for the sake of a bad one. An operation that is taken back gives tetrahedra
// new numbers, so that they are known by their corners.
bool CompoundOperations::improve_at(const Tet& place, const Tet& bad, double before)
{
    for (int operation = 0; operation < kOperations; ++operation) {
        // Tetrahedra next to each other share edges and faces. Without this, each operation would be tried four times
        // on average.
        if (!tried_.insert(subject_of(operation, place)).second || !attempt(find(place), operation))
            continue;
        if (smooth_all(bad, before)) {
            accept();
            return true;
        }
        take_back();
    }
    return false;
}

void CompoundOperations::accept()
{
    bad_.changed(mesh_, cavity_.created);
    for (const PointMove& move : moves_.made) {
        star_.load(mesh_, move.point);
        bad_.changed(mesh_, star_.tets());
    }
}

// -1 if there is none.
int32_t CompoundOperations::find(const Tet& corners) const
{
    const auto star = mesh_.star(corners[0]);
    const auto* found = std::find_if(star.begin(), star.end(), [&](int32_t t) { return mesh_.tet(t) == corners; });
    return found == star.end() ? -1 : *found;
}

Array<Tet> CompoundOperations::tets_around(const Tet& corners) const
{
    Array<int32_t> numbers;
    for (const int32_t v : corners)
        numbers.insert(numbers.end(), mesh_.star(v).begin(), mesh_.star(v).end());
    Array<Tet> around;
    for (const int32_t t : numbers)
        if (mesh_.tet(t) != corners)
            around.push_back(mesh_.tet(t));
    // By corners, because the numbers of tetrahedra change with every attempt that is taken back.
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
}

bool CompoundOperations::attempt(int32_t t, int operation)
{
    CLEFT_ASSERT(t >= 0);  // what was taken back has the same corners again
    moves_.clear();
    attempt_began_ = ++clock_;
    if (operation < 6) {
        const auto& edge = kEdgeCorners[operation];
        return apply_if(find_edge_removal(mesh_, t, edge[0], edge[1], bend_at(mesh_, search_, t, edge[0], edge[1]),
                                          cavity_, kShare));
    }
    if (operation < 10)
        return apply_if(find_face_removal(mesh_, t, operation - 6, cavity_, kShare));
    if (operation < 22) {
        const auto& edge = kEdgeCorners[(operation - 10) / 2];
        const int gone = operation % 2;
        return apply_if(contraction_.find(mesh_, t, edge[gone], edge[1 - gone], cavity_, kShare));
    }
    const auto& edge = kEdgeCorners[operation - 22];
    return mesh_.slot_count() < search_.most_tets && split_in_middle(t, edge[0], edge[1]);
}

bool CompoundOperations::apply_if(bool found)
{
    if (found)
        cavity_.apply(mesh_);
    return found;
}

bool CompoundOperations::split_in_middle(int32_t t, int corner_a, int corner_b)
{
    EdgeRing& ring = cavity_.ring;
    mesh_.ring(t, corner_a, corner_b, ring);
    Vec3 middle;
    if (!ring.whole || !smoother_.load_middle(ring, middle) ||
        !(smoother_.star().worst_at(middle, -1) > kShare * mesh_.worst(ring.tets)))
        return false;
    find_split(mesh_, cavity_);
    apply_split(mesh_, middle, cavity_);
    home_.push_back(middle);
    return true;
}

// Moves the corners of the new tetrahedra, the worst first, and then those of the bad one. True if it pays.
bool CompoundOperations::smooth_all(const Tet& bad, double before)
{
    // Nothing has to get better than the target: it is good enough.
    const double wanted = std::min(before + kLeastGain, target_);
    std::sort(cavity_.created.begin(), cavity_.created.end(), [&](int32_t s, int32_t t) {
        // The worst first, since it is the most likely to end the attempt.
        return mesh_.quality(s) != mesh_.quality(t) ? mesh_.quality(s) < mesh_.quality(t) : s < t;
    });
    for (const int32_t t : cavity_.created) {
        smooth_and_note(t);
        if (mesh_.quality(t) < kHopeful * before)
            return false;
    }
    if (mesh_.worst(cavity_.created) < wanted)
        for (const int32_t t : cavity_.created)
            smooth_and_note(t);
    if (mesh_.worst(cavity_.created) < wanted)
        return false;
    if (const int32_t t = find(bad); t >= 0)
        smooth_and_note(t);
    return pays(bad, wanted);
}

void CompoundOperations::smooth_and_note(int32_t t)
{
    for (const int32_t v : mesh_.tet(t)) {
        if (mesh_.quality(t) >= target_)
            break;
        if (is_smoothed(v))
            continue;
        if (Vec3 better; smoother_.find(v, false, better)) {
            moves_.apply(mesh_, v, better);
            disturb_around(v);
        }
        smoothed_[v] = ++clock_;
    }
}

// Nothing around the point has moved since the attempt smoothed it: it would stay where it is.
bool CompoundOperations::is_smoothed(int32_t v)
{
    smoothed_.resize(mesh_.points().size(), 0);
    disturbed_.resize(mesh_.points().size(), 0);
    return smoothed_[v] > std::max(disturbed_[v], attempt_began_);
}

void CompoundOperations::disturb_around(int32_t v)
{
    ++clock_;
    for (const int32_t t : mesh_.star(v))
        for (const int32_t w : mesh_.tet(t))
            disturbed_[w] = clock_;
}

// Everything new or moved, and the bad tetrahedron if there still is one, is as good as wanted.
bool CompoundOperations::pays(const Tet& bad, double wanted)
{
    const int32_t t = find(bad);
    if (!(mesh_.worst(cavity_.created) >= wanted) || (t >= 0 && !(mesh_.quality(t) >= wanted)))
        return false;
    return std::all_of(moves_.made.begin(), moves_.made.end(), [&](const PointMove& move) {
        star_.load(mesh_, move.point);
        return star_.worst_at(mesh_.point(move.point), -1) >= wanted;
    });
}

void CompoundOperations::take_back()
{
    // The tetrahedra come back last: between the moves they are the new ones.
    moves_.undo(mesh_);
    cavity_.undo(mesh_);
    bad_.renumbered(cavity_.old_tets);
}

}  // namespace cleft
