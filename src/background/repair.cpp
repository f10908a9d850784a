// Removes slivers from a background by flips and smoothing, while no material boundary is in the way.
#include "background/repair.hpp"

#include "base/degrees.hpp"
#include "base/per_worker.hpp"
#include "base/stage.hpp"
#include "mesh/adjacency.hpp"
#include "remeshing/angle_notes.hpp"
#include "remeshing/flips.hpp"
#include "remeshing/point_visits.hpp"
#include "remeshing/rounds.hpp"
#include "remeshing/smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
namespace
{

// The sweep mends most of what is better than this, and may leave a tetrahedron as bad as this.
constexpr double kSweepAngle = 22;  // degrees
// Points whose tetrahedra are all better than this have no need of it.
// With a greater angle the sweep would move nearly all points, for angles that nobody asks for.
constexpr double kGoodAngle = 38;  // degrees
// With six edges the repair took 1.1 times as long as TetGen, with two 0.74 times, and ended at the same angle.
constexpr size_t kEdgesTried = 2;  // the others never helped in 10,000 tries

// Looks for what helps a bad tetrahedron: flips, then moves of its corners.
class Finder
{
public:
    explicit Finder(const LocalMesh& mesh) : mesh_(mesh) {}

    // The steps are the flips and one for each corner. See Rounds::Find.
    int find(int32_t t, int step, double target, bool with_moves, Proposal& proposal)
    {
        if (step == 0 && find_flip(t, proposal))
            return 0;
        for (int corner = std::max(step - 1, 0); with_moves && corner < 4; ++corner)
            if (find_move(mesh_.tet(t)[corner], target, proposal))
                return corner + 2;
        return 0;
    }

private:
    bool find_flip(int32_t t, Proposal& proposal) const
    {
        proposal.kind = Proposal::Kind::edge_removal;
        const auto edges = most_obtuse_first(mesh_, t);
        for (size_t i = 0; i < kEdgesTried; ++i)
            if (find_edge_removal(mesh_, t, kEdgeCorners[edges[i]][0], kEdgeCorners[edges[i]][1], 0, proposal.cavity))
                return true;
        proposal.kind = Proposal::Kind::face_removal;
        for (int corner = 0; corner < 4; ++corner)
            if (find_face_removal(mesh_, t, corner, proposal.cavity))
                return true;
        proposal.kind = Proposal::Kind::none;
        return false;
    }

    bool find_move(int32_t v, double target, Proposal& proposal)
    {
        const Mat3 tangent = free_axes(mesh_.frozen(v));
        if (tangent.isZero())
            return false;
        star_.load(mesh_, v);
        const Place place = smoother_.climb(star_, mesh_.point(v), target, tangent, {});
        if (place.x == mesh_.point(v))
            return false;
        proposal.set_move(v, place.x, star_.tets());
        return true;
    }

    const LocalMesh& mesh_;
    Smoother smoother_;
    TetStar star_;
};

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
        LabelledMesh mesh = mesh_.take(run_);
        return {std::move(mesh.points), std::move(mesh.tets)};
    }

private:
    void improve_bad(double angle, bool with_smoothing, const Run& run);
    void smooth_poor(const Run& run);
    void move_to_centroid(int32_t v, const Mat3& tangent, TetStar& star);

    const Run& run_;
    const RepairOptions& options_;
    LocalMesh mesh_;
    WorstFirst bad_;
};

// Passes over the tetrahedra with a worse angle, until none is left or nothing helps.
void Repair::improve_bad(double angle, bool with_smoothing, const Run& run)
{
    const double target = sine_of(angle);
    bad_.collect_all(mesh_, target, run);
    Rounds rounds(mesh_, bad_);
    PerWorker<Finder> finders(run, mesh_);
    const auto find = [&](int worker, int32_t t, int step, Proposal& proposal) {
        return finders[worker].find(t, step, target, with_smoothing, proposal);
    };
    const double share = 1.0 / options_.passes;
    bool changed = true;
    for (int pass = 0; pass < options_.passes && changed; ++pass) {
        changed = rounds.visit(
            0, bad_.size(), target, find, [](const Proposal&) {}, run, pass * share, share);
        bad_.collect_next(mesh_, target);
    }
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
