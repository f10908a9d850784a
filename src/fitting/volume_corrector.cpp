// The shortest move that leaves the least of a residual, and as much of it as the shapes around allow.
#include "fitting/volume_corrector.hpp"

#include "base/per_worker.hpp"
#include "remeshing/ordered_points.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace cleft
{

namespace
{

// Smaller moves are not worth their price, in lengths of the root of the area around.
constexpr double kLeastMove = 2e-3;
// Directions in which the triangles at a point have less than this share of the heights of the strongest are along
// the interface.
constexpr double kLeastShare = 0.2;
// A point that cannot go further than this share of its way stays.
constexpr double kLeastApplied = 0.1;

// The shortest move that leaves the least of the residual (least squares), along the free axes: one direction on a
// smooth interface, two on a line where interfaces meet, three in a corner. No shift if it is too short to pay.
FitMove move_of(const Residual& residual, uint8_t frozen)
{
    FitMove move;
    if (residual.heights.squaredNorm() < kLeastMove * kLeastMove * residual.area * residual.area * residual.area)
        return move;
    const Mat3 free = free_axes(frozen);
    Eigen::SelfAdjointEigenSolver<Mat3> eigen;
    eigen.computeDirect(free * residual.normals * free);
    const double strongest = eigen.eigenvalues()[2];
    if (!(strongest > kLeastShare * residual.area))  // no free axis crosses the interface
        return move;
    move.along = free;
    for (int i = 0; i < 3; ++i)
        if (eigen.eigenvalues()[i] > kLeastShare * strongest) {
            const Vec3 direction = free * eigen.eigenvectors().col(i);
            move.shift += direction.dot(residual.heights) / eigen.eigenvalues()[i] * direction;
            move.along -= direction * direction.transpose();
        }
    return move;
}

}  // namespace

int64_t VolumeCorrector::apply(const Array<Residual>& residuals, Array<FitPoint>& points, VolumeDeficits& deficits,
                               const Run& run)
{
    CLEFT_ASSERT(residuals.size() == points.size());
    // In a fixed order: each move changes the shapes that limit the next.
    PerWorker<Scratch> scratch(run);
    Array<GainsOfVisit> gained(deficits.empty() ? 0 : points.size());
    visit_points_in_order(
        mesh_, points.count(), [&](int64_t i) { return points[i].number; }, run,
        [&](int worker, int32_t i) {
            GainsOfVisit* const gains = deficits.empty() ? nullptr : &gained[i];
            visit(residuals[i], points[i], gains, scratch[worker]);
            if (gains)
                gains->worker = worker;
        });
    // Sums depend on their order: that of the visits, not of the threads.
    for (const GainsOfVisit& of_visit : gained)
        for (int64_t k = of_visit.begin; k < of_visit.end; ++k) {
            const Gain& gain = scratch[of_visit.worker].gains[k];
            deficits.gain(gain.material, gain.volume);
        }
    int64_t held = 0;
    for (const Scratch& one : scratch)
        held += one.held;
    return held;
}

void VolumeCorrector::visit(const Residual& residual, FitPoint& point, GainsOfVisit* gains, Scratch& scratch)
{
    if (point.is_fixed)
        return;
    const int32_t v = point.number;
    FitMove move = move_of(residual, mesh_.frozen(v));
    const Vec3 moved = point.moved + move.shift;
    if (moved.norm() > most_moved_)
        move.shift = most_moved_ / moved.norm() * moved - point.moved;
    if (move.shift.isZero(0))
        return;
    const Applied applied = place_for(v, move, scratch);
    if (!(applied.share > 0)) {
        ++scratch.held;
        return;
    }
    if (gains)
        *gains = count_gains(applied.x - mesh_.point(v), scratch);
    mesh_.move(v, applied.x);
    point.moved += applied.share * move.shift;
}

// The star that is loaded is that of the point.
VolumeCorrector::GainsOfVisit VolumeCorrector::count_gains(const Vec3& shift, Scratch& scratch) const
{
    Array<Gain>& gains = scratch.gains;
    const int64_t first = gains.count();
    for (size_t k = 0; k < scratch.star.tets().size(); ++k) {
        const Material material = mesh_.material(scratch.star.tets()[k]);
        const double volume = scratch.star.volume_change(k, shift);
        const auto found =
            std::find_if(gains.begin() + first, gains.end(), [&](const Gain& g) { return g.material == material; });
        if (found != gains.end())
            found->volume += volume;
        else
            gains.push_back({material, volume});
    }
    return {0, first, gains.count()};
}

// All of the move, or a half, a quarter ...; where the place itself is bad, there may be a good one beside it along the
// interface.
VolumeCorrector::Applied VolumeCorrector::place_for(int32_t v, const FitMove& move, Scratch& scratch) const
{
    TetStar& star = scratch.star;
    star.load(mesh_, v);
    const Vec3 from = mesh_.point(v);
    // Straight moves are tried first, since climbing takes many times as long.
    if (star.worst_at(from + move.shift, floor_) > floor_)
        return {from + move.shift, 1};
    const double least = std::min(floor_, star.worst_at(from, -1));
    for (double share = 1; least > 0 && share > kLeastApplied; share *= 0.5) {
        if (share < 1 && star.worst_at(from + share * move.shift, least) > least)
            return {from + share * move.shift, share};
        const Place place = scratch.smoother.climb(star, from + share * move.shift, least, move.along, {});
        if (place.worst >= least)
            return {place.x, share};
    }
    return {from, 0};
}

}  // namespace cleft
