// Optimisation-based smoothing: moves a point so that the worst tetrahedron around it gets better.
#pragma once

#include "base/array.hpp"
#include "remeshing/tet_star.hpp"

#include <functional>

namespace cleft
{

// Moves a trial position back to where the point may be; false if there is no such place near.
using Projection = std::function<bool(Vec3&)>;

// A place for the centre of a star, and the worst quality there.
struct Place {
    Vec3 x;
    double worst;
};

class Smoother
{
public:
    // Climbs from x, in the plane or line that `tangent` projects on, until the worst tetrahedron is as good as
    // `target` or cannot be made better; every trial position goes through `projection` if there is one.
    Place climb(const TetStar& star, const Vec3& x, double target, const Mat3& tangent, const Projection& projection);

    // The best of a fixed set of places around x, up to a quarter of the reach away: for stars where climbing ends on a
    // ridge.
    Place explore(const TetStar& star, const Vec3& x, const Mat3& tangent, const Projection& projection);

    // Places at which shapes have been looked at until now.
    int64_t places() const { return places_; }

private:
    Vec3 ascent_direction(double worst) const;
    double first_step(const Vec3& direction, double worst, double reach) const;
    bool step(const TetStar& star, Place& place, const Mat3& tangent, const Projection& projection);

    int64_t places_ = 0;
    Array<double> quality_;
    Array<Vec3> gradient_;
};

// Projects on the axes that are not frozen.
Mat3 free_axes(uint8_t frozen);

}  // namespace cleft
