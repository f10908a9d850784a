// Smooths points one at a time: climbs along a direction in which the worst tetrahedra improve, or tries a set of
// places.
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

// Both bound the work at one point. A tetrahedron that is still bad comes again in the next pass, when its neighbours
// have changed, so more steps here gain little.
constexpr int kClimbs = 4;    // directions tried for a point
constexpr int kHalvings = 4;  // trial lengths for a direction
// With a smaller band a point goes back and forth between two tetrahedra that become the worst in turn. With a larger
// one, those that do not matter yet hold the point back.
constexpr double kActive = 0.03;  // tetrahedra this near to the worst are improved together
// At 20 degrees this gain is 0.006 degrees. Less would keep the search going for what nobody sees.
constexpr double kLeastGain = 1e-4;
// In shares of the reach. Small ones find places in narrow stars, large ones leave a ridge.
constexpr double kExploredRadii[] = {0.25, 0.1, 0.04};
// Below it, not even a move by a whole edge would gain a visible amount.
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
    // The shortest vector is needed within a hundredth only, as a direction. The limit of 20 is for gradients that
    // nearly cancel.
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
    // No further than half of an edge, where first-order estimates have lost their meaning.
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
    ++places_;
    star.gradients_at(place.x, quality_, gradient_);
    const Mat3 free = star.tangent_in_frame(tangent);
    for (Vec3& g : gradient_)
        g = free * g;
    place.worst = *std::min_element(quality_.begin(), quality_.end());
    const Vec3 direction = ascent_direction(place.worst);
    const double reach = star.reach(place.x);
    if (!(direction.norm() * reach > kLeastSlope))
        return false;
    double length = first_step(direction, place.worst, reach);
    // A trial must be better by the least gain, or the same places could be visited for ever.
    const double wanted = std::max(place.worst + kLeastGain, kLeastSine);
    for (int halving = 0; halving < kHalvings; ++halving, length *= 0.5) {
        Vec3 trial = place.x + star.to_mesh(length * direction, tangent);
        if (projection && !projection(trial))
            continue;
        ++places_;
        const double worst = star.worst_at(trial, wanted);
        if (worst > wanted) {
            place = {trial, worst};
            return true;
        }
    }
    return false;
}

Place Smoother::explore(const TetStar& star, const Vec3& x, const Mat3& tangent, const Projection& projection)
{
    Place best{x, std::max(star.worst_at(x, -1), kLeastSine)};
    const double reach = star.reach(x);
    const Mat3 free = star.tangent_in_frame(tangent);
    for (const double radius : kExploredRadii)
        for (int code = 0; code < 27; ++code) {
            const Vec3 along(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
            const Vec3 shift = free * along;
            // What is left of a direction across the plane or line would be mostly rounding error. Code 13 is the
            // centre itself.
            if (shift.norm() < 0.1 * along.norm() || code == 13)
                continue;
            Vec3 trial = x + star.to_mesh(radius * reach * shift.normalized(), tangent);
            if (projection && !projection(trial))
                continue;
            ++places_;
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
