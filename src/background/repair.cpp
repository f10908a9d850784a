// Removes slivers from a background by flips and smoothing, while no material boundary is in the way.
#include "background/repair.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "mesh/adjacency.hpp"
#include "remeshing/angle_notes.hpp"
#include "remeshing/flips.hpp"
#include "remeshing/point_visits.hpp"
#include "remeshing/smoothing.hpp"
#include "remeshing/worst_first.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
namespace
{

constexpr int64_t kRepairedAtOnce = 256;  // tetrahedra, between two looks for a cancel
// The sweep mends most of what is better than this, and may leave a tetrahedron as bad as this.
constexpr double kSweepAngle = 22;  // degrees
// Points whose tetrahedra are all better than this have no need of it.
// With a greater angle the sweep would move nearly all points, for angles that nobody asks for.
constexpr double kGoodAngle = 38;  // degrees
// With six edges the repair took 1.1 times as long as TetGen, with two 0.74 times, and ended at the same angle.
constexpr size_t kEdgesTried = 2;  // the others never helped in 10,000 tries

class Repair
{
public:
    Repair(TetMesh& mesh, const RepairOptions& options, const Run& run)
        : run_(run), options_(options), mesh_(std::move(mesh.points), std::move(mesh.tets), {}, run)
    {
    }

    // Flips first: a sweep over bad connections would only move points to bad places.
    void work()
    {
        Array<Step> shares(options_.sweeps + 2, {nullptr, 4});
        shares[0].share = 2;
        Steps steps(run_, shares);
        improve_bad(std::min(kSweepAngle, options_.target_angle), false, steps.next());
        for (int sweep = 0; sweep < options_.sweeps; ++sweep)
            smooth_poor(steps.next());
        improve_bad(options_.target_angle, true, steps.next());
    }

    const LocalMesh& mesh() const { return mesh_; }

    TetMesh take()
    {
        LabelledMesh mesh = mesh_.take();
        return {std::move(mesh.points), std::move(mesh.tets)};
    }

private:
    void improve_bad(double angle, bool with_smoothing, const Run& run);
    bool flip(int32_t t);
    bool smooth_corners(int32_t t, double target);
    void smooth_poor(const Run& run);
    void move_to_centroid(int32_t v, const Mat3& tangent, TetStar& star);

    const Run& run_;
    const RepairOptions& options_;
    LocalMesh mesh_;
    WorstFirst bad_;
    Cavity cavity_;
    Smoother smoother_;
    TetStar star_;
};

// Passes over the tetrahedra with a worse angle, until none is left or nothing helps.
void Repair::improve_bad(double angle, bool with_smoothing, const Run& run)
{
    const double target = sine_of(angle);
    bad_.collect_all(mesh_, target, run);
    bool changed = true;
    for (int pass = 0; pass < options_.passes && changed; ++pass) {
        changed = false;
        for (size_t i = 0; i < bad_.size(); ++i) {
            run.check_at(i, kRepairedAtOnce);
            const bool worth = bad_.worth_trying(mesh_, i, target);
            const bool done = worth && (flip(bad_[i]) || (with_smoothing && smooth_corners(bad_[i], target)));
            changed = changed || done;
            bad_.give_back(i, worth && !done);
        }
        bad_.collect_next(mesh_, target);
    }
}

bool Repair::flip(int32_t t)
{
    bool done = false;
    const auto edges = most_obtuse_first(mesh_, t);
    for (size_t i = 0; i < kEdgesTried && !done; ++i)
        done = remove_edge(mesh_, t, kEdgeCorners[edges[i]][0], kEdgeCorners[edges[i]][1], 0.0, cavity_);
    for (int corner = 0; corner < 4 && !done; ++corner)
        done = remove_face(mesh_, t, corner, cavity_);
    if (done)
        bad_.changed(mesh_, cavity_.created);
    return done;
}

bool Repair::smooth_corners(int32_t t, double target)
{
    bool moved = false;
    const Tet corners = mesh_.tet(t);
    for (const int32_t v : corners) {
        if (mesh_.quality(t) >= target)
            break;
        const Mat3 tangent = free_axes(mesh_.frozen(v));
        if (tangent.isZero())
            continue;
        star_.load(mesh_, v);
        const Place place = smoother_.climb(star_, mesh_.point(v), target, tangent, {});
        if (place.x == mesh_.point(v))
            continue;
        mesh_.move(v, place.x);
        bad_.changed(mesh_, star_.tets());
        moved = true;
    }
    return moved;
}

// One Gauss-Seidel sweep of points of poor tetrahedra towards the centroids of their stars. In a mesh of the wanted
// sizes every tetrahedron weighs the same: a volume over the wanted volume is about one.
void Repair::smooth_poor(const Run& run)
{
    const double good = sine_of(kGoodAngle);
    mesh_.find_qualities(run);
    Array<TetStar> stars(worker_count(run));
    const auto is_poor = [&](int32_t v) {
        const auto star = mesh_.star(v);
        return std::any_of(star.begin(), star.end(), [&](int32_t t) { return mesh_.quality(t) < good; });
    };
    PointVisits(mesh_, run).visit(is_poor, [&](int worker, int32_t v) {
        const Mat3 tangent = free_axes(mesh_.frozen(v));
        if (!tangent.isZero())
            move_to_centroid(v, tangent, stars[worker]);
    });
}

// The whole way or half of it, if that leaves nothing worse than the guard or the worst that was there.
void Repair::move_to_centroid(int32_t v, const Mat3& tangent, TetStar& star)
{
    star.load(mesh_, v);
    if (star.empty())
        return;
    const Vec3 from = mesh_.point(v);
    const Vec3 shift = tangent * (star.centroid(from) - from);
    double floor = sine_of(kSweepAngle);
    if (star.worst_at(from + shift, floor) > floor) {
        mesh_.move(v, from + shift);
        return;
    }
    // A star that is already worse than the guard may still get better, but never flat.
    floor = std::max(std::min(floor, star.worst_at(from, 0)), kLeastSine);
    for (const double part : {1.0, 0.5})
        if (star.worst_at(from + part * shift, floor) > floor) {
            mesh_.move(v, from + part * shift);
            return;
        }
}

}  // namespace

void repair(TetMesh& mesh, const RepairOptions& options, const Run& run)
{
    Stage stage(run, "background.repair", {{"background: repairing", 1}});
    const Run of_repair = stage.next();
    Repair repair(mesh, options, of_repair);
    note_angles(repair.mesh(), "background.repair", "before", run);
    repair.work();
    note_angles(repair.mesh(), "background.repair", "after", run);
    mesh = repair.take();
}

}  // namespace cleft
