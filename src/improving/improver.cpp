#include "improving/improver.hpp"

#include "mesh/adjacency.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/flips.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

constexpr size_t kImprovedAtOnce = 16;  // tetrahedra, between two looks for a cancel: a rescue takes milliseconds

// Dear operations are for a few: where a target is out of reach for many (random noise, an angle asked too much), only
// the worst get them, one in so many tetrahedra of the mesh and some more.
constexpr size_t kThoroughOneIn = 200, kThoroughAtLeast = 200;
constexpr size_t kAttemptsOneIn = 10000, kAttemptsAtLeast = 5;
constexpr size_t kWideOneIn = 100000, kWideAtLeast = 5;

// The tetrahedra at the corners of some, these included, ascending.
void add_around(const LocalMesh& mesh, std::vector<int32_t>& tets)
{
    std::vector<int32_t> found;
    for (const int32_t t : tets)
        for (const int32_t v : mesh.tet(t))
            found.insert(found.end(), mesh.star(v).begin(), mesh.star(v).end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    tets = std::move(found);
}

size_t attempts_in_pass(const Search& search, size_t tets)
{
    if (!search.compound)
        return 0;
    return search.wide ? tets / kWideOneIn + kWideAtLeast : tets / kAttemptsOneIn + kAttemptsAtLeast;
}

}  // namespace

Improver::Improver(LocalMesh& mesh, const Volume& volume, double target, const Run& run)
    : target_(target), voxel_(volume.grid().spacing.minCoeff()), mesh_(mesh), constraint_(volume)
{
    mesh_.find_qualities(run);
    home_ = mesh_.points();
}

void Improver::work(const Search& search, const Run& run)
{
    search_ = search;
    if (started_)
        bad_.collect_left(mesh_, target_);
    else
        bad_.collect_all(mesh_, target_, run);
    started_ = true;
    const auto tets = static_cast<size_t>(mesh_.slot_count());
    const size_t most = search.thorough ? tets / kThoroughOneIn + kThoroughAtLeast : tets;
    bool changed = true;
    for (int pass = 0; pass < search.passes && changed; ++pass) {
        changed = false;
        attempts_left_ = attempts_in_pass(search, tets);
        for (size_t i = 0; i < bad_.size(); ++i) {
            if (i % kImprovedAtOnce == 0)
                run.report((pass + double(i) / double(bad_.size())) / search.passes);
            const bool worth = i < most && bad_.worth_trying(mesh_, i, target_);
            const bool done = worth && improve_tet(bad_[i]);
            changed = changed || done;
            bad_.give_back(i, worth && !done);
        }
        bad_.collect_next(mesh_, target_);
    }
}

void Improver::aim_higher(double target)
{
    constexpr int kRings = 3;
    target_ = target;
    std::vector<int32_t> near;
    for (size_t i = 0; i < bad_.size(); ++i)
        near.push_back(bad_[i]);
    for (int ring = 0; ring < kRings; ++ring)
        add_around(mesh_, near);
    bad_.changed(mesh_, near);
}

bool Improver::improve_tet(int32_t t)
{
    const bool moved = smooth_corners(t);
    if (moved && mesh_.quality(t) >= target_)
        return true;
    if (change_connections(t) || moved)
        return true;
    if (attempts_left_ == 0)
        return false;
    --attempts_left_;
    return rescue(t);
}

bool Improver::smooth_corners(int32_t t)
{
    bool moved = false;
    const Tet corners = mesh_.tet(t);
    for (const int32_t v : corners)
        if (mesh_.quality(t) < target_ && smooth(v, search_.thorough)) {
            bad_.changed(mesh_, star_.tets());
            moved = true;
        }
    return moved;
}

bool Improver::smooth(int32_t v, bool thorough)
{
    if (mesh_.frozen(v) == 7)
        return false;
    star_.load(mesh_, v);
    const Place place = better_place(v, thorough);
    if (place.x == mesh_.point(v))
        return false;
    mesh_.move(v, place.x);
    ++counts_.moved;
    return true;
}

// Where the star that is loaded is better with the point there; the point's own place if there is none.
Place Improver::better_place(int32_t v, bool thorough)
{
    const Vec3 from = mesh_.point(v);
    constrain(star_.tets(), from, home_[static_cast<size_t>(v)], mesh_.frozen(v));
    if (constraint_.fixed())
        return {from, -1};
    const auto project = [&](Vec3& x) { return constraint_.project(x); };
    const Place place = smoother_.climb(star_, from, target_, constraint_.tangent(), project);
    if (!thorough || place.worst >= target_)
        return place;
    const Place start = smoother_.explore(star_, place.x, constraint_.tangent(), project);
    return start.x == place.x ? place : smoother_.climb(star_, start.x, target_, constraint_.tangent(), project);
}

void Improver::constrain(const std::vector<int32_t>& tets, const Vec3& x, const Vec3& home, uint8_t frozen)
{
    const double reach = star_.reach(x);
    constraint_.set(mesh_, tets, x, home, frozen, reach, search_.tolerance * std::min(reach, voxel_));
}

bool Improver::change_connections(int32_t t)
{
    const auto done = [&](int64_t& count) {
        ++count;
        bad_.changed(mesh_, cavity_.created);
        return true;
    };
    for (const size_t e : most_obtuse_first(mesh_, t)) {
        const auto& edge = kEdgeCorners[e];
        if (remove_edge(mesh_, t, edge[0], edge[1], bend(t, edge[0], edge[1]), cavity_))
            return done(counts_.edges_removed);
    }
    for (int corner = 0; corner < 4; ++corner)
        if (remove_face(mesh_, t, corner, cavity_))
            return done(counts_.faces_removed);
    for (const auto& edge : kEdgeCorners)
        if (contraction_.contract(mesh_, t, edge[0], edge[1], cavity_) ||
            contraction_.contract(mesh_, t, edge[1], edge[0], cavity_))
            return done(counts_.contracted);
    for (const auto& edge : kEdgeCorners)
        if (split(t, edge[0], edge[1]))
            return done(counts_.split);
    return false;
}

double Improver::bend(int32_t t, int corner_a, int corner_b) const
{
    const Tet& v = mesh_.tet(t);
    return search_.bend *
           (mesh_.point(v[static_cast<size_t>(corner_a)]) - mesh_.point(v[static_cast<size_t>(corner_b)])).norm();
}

// A point put into the edge and smoothed, if that makes the worst tetrahedron at the edge better.
bool Improver::split(int32_t t, int corner_a, int corner_b)
{
    EdgeRing& ring = cavity_.ring;
    mesh_.ring(t, corner_a, corner_b, ring);
    if (!ring.whole)
        return false;
    star_.load(mesh_, ring);
    const double floor = std::max(mesh_.worst(ring.tets), kLeastSine);
    Vec3 middle = 0.5 * (mesh_.point(ring.a) + mesh_.point(ring.b));
    constrain(ring.tets, middle, middle, frozen_on_edge(mesh_, ring));
    const auto project = [&](Vec3& x) { return constraint_.project(x); };
    if (!project(middle))
        return false;
    const Place place = smoother_.climb(star_, middle, target_, constraint_.tangent(), project);
    if (!(place.worst > floor))
        return false;
    split_edge(mesh_, ring, place.x, cavity_);
    home_.push_back(place.x);
    return true;
}

}  // namespace cleft
