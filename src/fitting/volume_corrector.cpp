// The shortest move that leaves the least of a residual, and as much of it as the shapes around allow.
#include "fitting/volume_corrector.hpp"

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
    int64_t held = 0;
    // One after the other in a fixed order: each move changes the shapes that limit the next.
    for (size_t i = 0; i < points.size(); ++i) {
        run.check_at(i, 1 << 12);
        if (points[i].is_fixed)
            continue;
        const int32_t v = points[i].number;
        const FitMove move = move_of(residuals[i], mesh_.frozen(v));
        if (move.shift.isZero(0))
            continue;
        const Applied applied = place_for(v, move);
        if (applied.share > 0) {
            if (!deficits.empty())
                count_gains(applied.x - mesh_.point(v), deficits);
            mesh_.move(v, applied.x);
            points[i].moved += applied.share * move.shift;
        } else
            ++held;
    }
    return held;
}

// star_ has the star of the point.
void VolumeCorrector::count_gains(const Vec3& shift, VolumeDeficits& deficits) const
{
    for (size_t i = 0; i < star_.tets().size(); ++i)
        deficits.gain(mesh_.material(star_.tets()[i]), star_.volume_change(i, shift));
}

// All of the move, or a half, a quarter ...; where the place itself is bad, there may be a good one beside it along the
// interface.
VolumeCorrector::Applied VolumeCorrector::place_for(int32_t v, const FitMove& move)
{
    star_.load(mesh_, v);
    const Vec3 from = mesh_.point(v);
    // Straight moves are tried first, since climbing takes many times as long.
    if (star_.worst_at(from + move.shift, floor_) > floor_)
        return {from + move.shift, 1};
    const double least = std::min(floor_, star_.worst_at(from, -1));
    for (double share = 1; least > 0 && share > kLeastApplied; share *= 0.5) {
        if (share < 1 && star_.worst_at(from + share * move.shift, least) > least)
            return {from + share * move.shift, share};
        const Place place = smoother_.climb(star_, from + share * move.shift, least, move.along, {});
        if (place.worst >= least)
            return {place.x, share};
    }
    return {from, 0};
}

}  // namespace cleft
