// A point climbs along the directions that its ties leave free, and is projected back onto them.
#include "improving/constrained_smoother.hpp"

#include "remeshing/edge_split.hpp"

#include <algorithm>

namespace cleft
{

ConstrainedSmoother::ConstrainedSmoother(const LocalMesh& mesh, const Volume& volume, const Array<Vec3>& home)
    : mesh_(mesh), voxel_(volume.grid().spacing.minCoeff()), home_(home), constraint_(volume)
{
}

void ConstrainedSmoother::aim_at(double target, double tolerance)
{
    target_ = target;
    tolerance_ = tolerance;
}

bool ConstrainedSmoother::find(int32_t v, bool thorough, Vec3& better)
{
    // Spares the star and the samples for points that cannot move at all.
    if (mesh_.frozen(v) == 7)
        return false;
    star_.load(mesh_, v);
    better = better_place(v, thorough).x;
    return better != mesh_.point(v);
}

// Where the star that is loaded is better with the point there; the point's own place if there is none.
Place ConstrainedSmoother::better_place(int32_t v, bool thorough)
{
    const Vec3 from = mesh_.point(v);
    constrain(star_.tets(), from, home_[v], mesh_.frozen(v));
    if (constraint_.fixed())
        return {from, -1};
    const Place place = climb(from);
    // Exploring costs some eighty trials, so it comes only where climbing has ended below the target.
    if (!thorough || place.worst >= target_)
        return place;
    const auto project = [&](Vec3& x) { return constraint_.project(x); };
    const Place start = smoother_.explore(star_, place.x, constraint_.tangent(), project);
    return start.x == place.x ? place : climb(start.x);
}

// The tolerance is at most a share of the edges, or points of small tetrahedra could leave their interface.
void ConstrainedSmoother::constrain(const Array<int32_t>& tets, const Vec3& x, const Vec3& home, uint8_t frozen)
{
    const double reach = star_.reach(x);
    constraint_.set(mesh_, tets, x, home, frozen, reach, tolerance_ * std::min(reach, voxel_));
}

bool ConstrainedSmoother::load_middle(const EdgeRing& ring, Vec3& middle)
{
    star_.load(mesh_, ring);
    middle = 0.5 * (mesh_.point(ring.a) + mesh_.point(ring.b));
    constrain(ring.tets, middle, middle, frozen_on_edge(mesh_, ring));
    return constraint_.project(middle);
}

Place ConstrainedSmoother::climb(const Vec3& from)
{
    return smoother_.climb(star_, from, target_, constraint_.tangent(),
                           [&](Vec3& x) { return constraint_.project(x); });
}

}  // namespace cleft
