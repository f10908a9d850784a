#include "improving/improve.hpp"

#include "base/stage_timer.hpp"
#include "improving/tie_constraint.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/angle_notes.hpp"
#include "mesh/contraction.hpp"
#include "mesh/edge_split.hpp"
#include "mesh/flips.hpp"
#include "mesh/worst_first.hpp"

#include <cmath>

namespace cleft
{

namespace
{

// How far an interface may move when an edge in it is flipped, in lengths of the edge.
constexpr double kBend = 0.05;

// One search: passes over the tetrahedra below an angle. Interface points may be `tolerance` edge lengths off the tie.
struct Search {
    double angle;
    int passes;
    double tolerance;
};

double sine(double degrees) { return std::sin(degrees * M_PI / 180); }

std::vector<Search> searches_of(const ImproveOptions& options)
{
    const double angle = options.target_angle;
    if (options.effort == Effort::fast)
        return {{angle, 6, 0.0}};
    // What is still bad after an honest try may leave the tie a little: an angle for a distance.
    return {{angle, 10, 0.0}, {0.85 * angle, 4, 0.05}, {0.85 * angle, 4, 0.1}};
}

struct Counts {
    int64_t moved = 0, edges_removed = 0, faces_removed = 0, contracted = 0, split = 0;
};

class Improver
{
public:
    Improver(LabelledMesh& mesh, const Volume& volume, const Run& run)
        : run_(run), mesh_(std::move(mesh.points), std::move(mesh.tets), std::move(mesh.material)), constraint_(volume)
    {
    }

    void work(const Search& search);
    LabelledMesh take() { return mesh_.take(); }
    const Counts& counts() const { return counts_; }

private:
    bool improve_tet(int32_t t);
    bool smooth_corners(int32_t t);
    bool smooth(int32_t v);
    bool change_connections(int32_t t);
    bool split(int32_t t, int corner_a, int corner_b);

    const Run& run_;
    LocalMesh mesh_;
    TieConstraint constraint_;
    WorstFirst bad_;
    Cavity cavity_;
    Contraction contraction_;
    Smoother smoother_;
    Star star_;
    Counts counts_;
    double target_ = 0, tolerance_ = 0;  // of the search
};

void Improver::work(const Search& search)
{
    target_ = sine(search.angle);
    tolerance_ = search.tolerance;
    bad_.collect_all(mesh_, target_);
    bool changed = true;
    for (int pass = 0; pass < search.passes && changed; ++pass) {
        changed = false;
        for (size_t i = 0; i < bad_.size(); ++i) {
            if (i % 16 == 0)
                run_.report((pass + double(i) / double(bad_.size())) / search.passes, "improving");
            const bool worth = bad_.worth_trying(mesh_, i, target_);
            const bool done = worth && improve_tet(bad_[i]);
            changed = changed || done;
            bad_.give_back(i, worth && !done);
        }
        bad_.collect_next(mesh_, target_);
    }
}

bool Improver::improve_tet(int32_t t)
{
    const bool moved = smooth_corners(t);
    return (moved && mesh_.quality(t) >= target_) || change_connections(t) || moved;
}

bool Improver::smooth_corners(int32_t t)
{
    bool moved = false;
    const Tet corners = mesh_.tet(t);
    for (const int32_t v : corners)
        if (mesh_.quality(t) < target_)
            moved = smooth(v) || moved;
    return moved;
}

bool Improver::smooth(int32_t v)
{
    if (mesh_.frozen(v) == 7)
        return false;
    star_.load(mesh_, v);
    const Vec3 from = mesh_.point(v);
    const double reach = star_.reach(from);
    constraint_.set(mesh_, star_.tets(), from, mesh_.frozen(v), reach, tolerance_ * reach);
    if (constraint_.fixed())
        return false;
    const Place place =
        smoother_.climb(star_, from, target_, constraint_.tangent(), [&](Vec3& x) { return constraint_.project(x); });
    if (place.x == from)
        return false;
    mesh_.move(v, place.x);
    bad_.changed(mesh_, star_.tets());
    ++counts_.moved;
    return true;
}

bool Improver::change_connections(int32_t t)
{
    const auto done = [&](int64_t& count) {
        ++count;
        bad_.changed(mesh_, cavity_.created);
        return true;
    };
    for (const auto& edge : kEdgeCorners) {
        const double length = (mesh_.point(mesh_.tet(t)[static_cast<size_t>(edge[0])]) -
                               mesh_.point(mesh_.tet(t)[static_cast<size_t>(edge[1])]))
                                  .norm();
        if (remove_edge(mesh_, t, edge[0], edge[1], kBend * length, cavity_))
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
    star_.load(mesh_, ring);
    const double floor = std::max(mesh_.worst(ring.tets), kLeastSine);
    Vec3 middle = 0.5 * (mesh_.point(ring.a) + mesh_.point(ring.b));
    const double reach = star_.reach(middle);
    constraint_.set(mesh_, ring.tets, middle, frozen_on_edge(mesh_, ring), reach, tolerance_ * reach);
    if (!constraint_.project(middle))
        return false;
    const auto project = [&](Vec3& x) { return constraint_.project(x); };
    const Place place = smoother_.climb(star_, middle, target_, constraint_.tangent(), project);
    if (!(place.worst > floor))
        return false;
    split_edge(mesh_, ring, place.x, cavity_);
    return true;
}

}  // namespace

void improve(LabelledMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run)
{
    if (options.effort == Effort::off)
        return;
    const StageTimer timer(run, "improving");
    run.report(0, "improving");
    note_angles(mesh.points, mesh.tets, "improving", "before", run);
    Improver improver(mesh, volume, run);
    for (const Search& search : searches_of(options))
        improver.work(search);
    mesh = improver.take();
    note_angles(mesh.points, mesh.tets, "improving", "after", run);
    const Counts& counts = improver.counts();
    run.note("improving.points_moved", static_cast<double>(counts.moved));
    run.note("improving.edges_removed", static_cast<double>(counts.edges_removed));
    run.note("improving.faces_removed", static_cast<double>(counts.faces_removed));
    run.note("improving.edges_contracted", static_cast<double>(counts.contracted));
    run.note("improving.edges_split", static_cast<double>(counts.split));
    run.report(1, "improving");
}

}  // namespace cleft
