// Flips and moves that repair shapes, worst tetrahedra first.
#include "background/shape_repair.hpp"

#include "base/degrees.hpp"
#include "base/per_worker.hpp"
#include "mesh/adjacency.hpp"
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

// The whole way or half of it, if that leaves nothing worse than the guard or the worst that was there.
void move_to_centroid(LocalMesh& mesh, int32_t v, const Mat3& tangent, TetStar& star)
{
    star.load(mesh, v);
    if (star.empty())
        return;
    const Vec3 from = mesh.point(v);
    const Vec3 shift = tangent * (star.centroid(from) - from);
    double floor = sine_of(kSweepAngle);
    if (star.worst_at(from + shift, floor) > floor) {
        mesh.move(v, from + shift);
        return;
    }
    // A star that is already worse than the guard may still get better, but never flat.
    floor = std::max(std::min(floor, star.worst_at(from, 0)), kLeastSine);
    for (const double part : {1.0, 0.5})
        if (star.worst_at(from + part * shift, floor) > floor) {
            mesh.move(v, from + part * shift);
            return;
        }
}

}  // namespace

void ShapeRepair::improve_bad(double angle, int passes, bool with_moves, const Run& run)
{
    const double target = sine_of(angle);
    bad_.collect_all(mesh_, target, run);
    Rounds rounds(mesh_, bad_);
    PerWorker<Finder> finders(run, mesh_);
    const auto find = [&](int worker, int32_t t, int step, Proposal& proposal) {
        return finders[worker].find(t, step, target, with_moves, proposal);
    };
    const double share = 1.0 / passes;
    bool changed = true;
    for (int pass = 0; pass < passes && changed; ++pass) {
        changed = rounds.visit(
            0, bad_.size(), target, find, [](const Proposal&) {}, run, pass * share, share);
        bad_.collect_next(mesh_, target);
    }
}

void ShapeRepair::smooth_poor(const Run& run)
{
    const double good = sine_of(kGoodAngle);
    mesh_.find_qualities(run);
    PerWorker<TetStar> stars(run);
    const auto is_poor = [&](int32_t v) {
        const auto star = mesh_.star(v);
        return std::any_of(star.begin(), star.end(), [&](int32_t t) { return mesh_.quality(t) < good; });
    };
    PointVisits(mesh_, run).visit(is_poor, [&](int worker, int32_t v) {
        const Mat3 tangent = free_axes(mesh_.frozen(v));
        if (!tangent.isZero())
            move_to_centroid(mesh_, v, tangent, stars[worker]);
    });
}

}  // namespace cleft
