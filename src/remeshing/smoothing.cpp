#include "remeshing/smoothing.hpp"

#include "mesh/adjacency.hpp"
#include "mesh/quality.hpp"
#include "remeshing/cavity.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{
namespace
{

constexpr int kClimbs = 4;        // directions tried for a point
constexpr int kHalvings = 4;      // trial lengths for a direction
constexpr double kActive = 0.03;  // tetrahedra this near to the worst are improved together
constexpr double kLeastGain = 1e-4;
constexpr double kExploredRadii[] = {0.25, 0.1, 0.04};
constexpr double kLeastSlope = 1e-3;  // gain of quality for a typical edge length

}  // namespace

Mat3 free_axes(uint8_t frozen)
{
    Mat3 projector = Mat3::Identity();
    for (int axis = 0; axis < 3; ++axis)
        if (frozen >> axis & 1)
            projector(axis, axis) = 0;
    return projector;
}

// The shortest vector in the convex hull of the active gradients improves all of them (Gilbert's iteration).
Vec3 Smoother::ascent_direction(double worst) const
{
    CLEFT_ASSERT(quality_.size() == gradient_.size());
    Vec3 shortest(0, 0, 0);
    bool any = false;
    for (size_t i = 0; i < quality_.size() && !any; ++i)
        if (quality_[i] <= worst) {
            shortest = gradient_[i];
            any = true;
        }
    for (int iteration = 0; iteration < 20; ++iteration) {
        size_t extreme = quality_.size();
        double least = shortest.squaredNorm() * (1 - 1e-2);
        for (size_t i = 0; i < quality_.size(); ++i)
            if (quality_[i] <= worst + kActive && gradient_[i].dot(shortest) < least) {
                least = gradient_[i].dot(shortest);
                extreme = i;
            }
        if (extreme == quality_.size())
            break;
        const Vec3 towards = gradient_[extreme] - shortest;
        const double t = -shortest.dot(towards) / towards.squaredNorm();
        shortest += std::clamp(t, 0.0, 1.0) * towards;
    }
    return shortest;
}

// The length at which, to first order, a tetrahedron that is now better becomes the worst.
double Smoother::first_step(const Vec3& direction, double worst, double reach) const
{
    const double rate = direction.squaredNorm();
    double length = 0.5 * reach / std::sqrt(rate);
    for (size_t i = 0; i < quality_.size(); ++i) {
        const double relative = rate - gradient_[i].dot(direction);
        if (quality_[i] > worst + kActive && relative > 0)
            length = std::min(length, (quality_[i] - worst) / relative);
    }
    return length;
}

bool Smoother::step(const TetStar& star, Place& place, const Mat3& tangent, const Projection& projection)
{
    star.gradients_at(place.x, quality_, gradient_);
    for (Vec3& g : gradient_)
        g = tangent * g;
    place.worst = *std::min_element(quality_.begin(), quality_.end());
    const Vec3 direction = ascent_direction(place.worst);
    const double reach = star.reach(place.x);
    if (!(direction.norm() * reach > kLeastSlope))
        return false;
    double length = first_step(direction, place.worst, reach);
    const double wanted = std::max(place.worst + kLeastGain, kLeastSine);
    for (int halving = 0; halving < kHalvings; ++halving, length *= 0.5) {
        Vec3 trial = place.x + length * direction;
        if (projection && !projection(trial))
            continue;
        const double worst = star.worst_at(trial, wanted);
        if (worst > wanted) {
            place = {trial, worst};
            return true;
        }
    }
    return false;
}

Place Smoother::explore(const TetStar& star, const Vec3& x, const Mat3& tangent, const Projection& projection) const
{
    Place best{x, std::max(star.worst_at(x, -1), kLeastSine)};
    const double reach = star.reach(x);
    for (const double radius : kExploredRadii)
        for (int code = 0; code < 27; ++code) {
            const Vec3 along(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
            const Vec3 shift = tangent * along;
            if (shift.norm() < 0.1 * along.norm() || code == 13)
                continue;
            Vec3 trial = x + radius * reach * shift.normalized();
            if (projection && !projection(trial))
                continue;
            const double worst = star.worst_at(trial, best.worst);
            if (worst > best.worst + kLeastGain)
                best = {trial, worst};
        }
    return best;
}

Place Smoother::climb(const TetStar& star, const Vec3& x, double target, const Mat3& tangent,
                      const Projection& projection)
{
    Place place{x, -1};
    for (int i = 0; i < kClimbs && place.worst < target; ++i)
        if (!step(star, place, tangent, projection))
            break;
    return place;
}

}  // namespace cleft
