// Passes over the bad tetrahedra: cheap operations for all, expensive ones for the worst.
#include "improving/improver.hpp"

#include "improving/smooth_bad.hpp"
#include "mesh/adjacency.hpp"
#include "remeshing/edge_split.hpp"
#include "remeshing/flips.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Tetrahedra between two looks for a cancel: a compound operation takes milliseconds.
constexpr size_t kImprovedAtOnce = 16;

// Expensive operations are for a few: where a target is out of reach for many (random noise, an angle asked too much),
// only the worst get them, one in so many tetrahedra of the mesh and some more.
// The first number of each pair bounds the time in large meshes. The second leaves small meshes some attempts too.
constexpr size_t kThoroughOneIn = 200, kThoroughAtLeast = 200;
constexpr size_t kAttemptsOneIn = 10000, kAttemptsAtLeast = 5;
constexpr size_t kWideOneIn = 100000, kWideAtLeast = 5;

// Where a target is out of reach, each pass makes as many tetrahedra bad as it makes good. After so many passes in a
// row with hardly fewer bad ones the search ends, if there are many: checkerboards at 32 degrees then take a fifth of
// the time. The first pass over labels of random voxels leaves more bad ones than before, and the later ones ever
// fewer.
constexpr double kStalled = 0.98;
constexpr int kStalledPasses = 2;

// So many bad tetrahedra are worth a start on all threads, which a search of one thread then takes up. In small meshes
// the whole search takes less time than that saves, and goes a better way: one tetrahedron after the other is done
// with.
constexpr size_t kWorthThreads = 5000;

// The tetrahedra at the corners of some, these included, ascending.
void add_around(const LocalMesh& mesh, Array<int32_t>& tets)
{
    Array<int32_t> found;
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
    : target_(target),
      mesh_(mesh),
      volume_(volume),
      home_(mesh.points()),
      smoother_(mesh, volume, home_),
      compound_(mesh, smoother_, bad_)
{
    // Once for all tetrahedra, by several threads; the search itself runs on one.
    mesh_.find_qualities(run);
}

void Improver::work(const Search& search, const Run& run)
{
    search_ = search;
    smoother_.aim_at(target_, search.tolerance);
    if (started_)
        bad_.collect_left(mesh_, target_);
    else
        bad_.collect_all(mesh_, target_, run);
    if (!started_ && bad_.size() > kWorthThreads)
        smooth_all(run);
    started_ = true;
    const size_t tets = to_size(mesh_.slot_count());
    const size_t many = tets / kThoroughOneIn + kThoroughAtLeast;
    const size_t most = search.thorough ? many : tets;
    bool changed = true;
    int stalled = 0;
    for (int pass = 0; pass < search.passes && changed && stalled < kStalledPasses; ++pass) {
        changed = false;
        const size_t before = bad_.size();
        attempts_left_ = attempts_in_pass(search, tets);
        for (size_t i = 0; i < bad_.size(); ++i) {
            if (i % kImprovedAtOnce == 0)
                run.report((pass + double(i) / double(bad_.size())) / search.passes);
            const bool worth = i < most && bad_.worth_trying(mesh_, i, target_);
            const bool done = worth && improve_tet(bad_[i]);
            changed = changed || done;
            // Given back even if it was not tried, so that the next pass finds all that are left.
            bad_.give_back(i, worth && !done);
        }
        bad_.collect_next(mesh_, target_);
        const bool is_stalled = bad_.size() > many && double(bad_.size()) > kStalled * double(before);
        stalled = is_stalled ? stalled + 1 : 0;
    }
}

// Most bad tetrahedra need no more than better places for their corners. A second round over all helped few, and cost
// more than it saved.
void Improver::smooth_all(const Run& run)
{
    const Array<MovedCorners> moved = smooth_bad({mesh_, volume_, home_, target_, search_.tolerance}, bad_, run);
    counts_.tried += static_cast<int64_t>(bad_.size());
    for (size_t i = 0; i < bad_.size(); ++i) {
        for (size_t corner = 0; corner < 4; ++corner)
            if (moved[i] >> corner & 1u) {
                ++counts_.moved;
                const auto star = mesh_.star(mesh_.tet(bad_[i])[corner]);
                bad_.changed(mesh_, Array<int32_t>(star.begin(), star.end()));
            }
        bad_.give_back(i, false);
    }
    bad_.collect_next(mesh_, target_);
}

void Improver::aim_higher(double target)
{
    // With fewer rings the search has no room to take another way. With more, it works on tetrahedra that are far from
    // any bad one.
    constexpr int kRings = 3;
    target_ = target;
    Array<int32_t> near;
    for (size_t i = 0; i < bad_.size(); ++i)
        near.push_back(bad_[i]);
    for (int ring = 0; ring < kRings; ++ring)
        add_around(mesh_, near);
    bad_.changed(mesh_, near);
}

bool Improver::improve_tet(int32_t t)
{
    ++counts_.tried;
    // First, since it is cheap and changes no connections.
    const bool moved = smooth_corners(t);
    if (moved && mesh_.quality(t) >= target_)
        return true;
    if (change_connections(t) || moved)
        return true;
    if (attempts_left_ == 0)
        return false;
    --attempts_left_;
    if (!compound_.improve(t, search_, target_))
        return false;
    counts_.moved += compound_.points_moved();
    ++counts_.compound;
    return true;
}

bool Improver::smooth_corners(int32_t t)
{
    bool moved = false;
    const Tet corners = mesh_.tet(t);
    for (const int32_t v : corners)
        if (mesh_.quality(t) < target_ && smoother_.smooth(v, search_.thorough)) {
            ++counts_.moved;
            bad_.changed(mesh_, smoother_.star().tets());
            moved = true;
        }
    return moved;
}

bool Improver::change_connections(int32_t t)
{
    const auto done = [&](int64_t& count) {
        ++count;
        bad_.changed(mesh_, cavity_.created);
        return true;
    };
    // In a fixed order, and the first that helps is taken: trying all to find the best would cost far more. Splits come
    // last, because they alone add points.
    for (const size_t e : most_obtuse_first(mesh_, t)) {
        const auto& edge = kEdgeCorners[e];
        if (remove_edge(mesh_, t, edge[0], edge[1], bend_at(mesh_, search_, t, edge[0], edge[1]), cavity_))
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

// A point put into the edge and smoothed, if that makes the worst tetrahedron at the edge better.
bool Improver::split(int32_t t, int corner_a, int corner_b)
{
    EdgeRing& ring = cavity_.ring;
    mesh_.ring(t, corner_a, corner_b, ring);
    Vec3 middle;
    // The new point must lie on the tie of the materials around the edge, or the interface would get a dent.
    if (!ring.whole || !smoother_.load_middle(ring, middle))
        return false;
    const double floor = std::max(mesh_.worst(ring.tets), kLeastSine);
    const Place place = smoother_.climb(middle);
    if (!(place.worst > floor))
        return false;
    split_edge(mesh_, ring, place.x, cavity_);
    smoother_.add_point(place.x);
    return true;
}

}  // namespace cleft
