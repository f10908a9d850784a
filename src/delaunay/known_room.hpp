// Where a brick knows all points.
#pragma once

#include "base/array.hpp"
#include "mesh/bounding_box.hpp"

namespace cleft
{

// A coarse grid around the brick's box has the least distance from the box to points that were left out. The cells at
// the border of the grid go on without end.
class KnownRoom
{
public:
    // Nothing is left out.
    void clear(const BoundingBox& own);
    // The box has points that are left out.
    void leave_out(const BoundingBox& box);
    // False if any point that is left out may lie in the ball.
    bool holds_ball(const Vec3& centre, double radius) const;

private:
    template <class Visit>
    void for_cells(const BoundingBox& box, const Visit& visit) const;

    BoundingBox own_;
    Vec3 corner_, cells_per_length_;
    Array<double> least_;
};

}  // namespace cleft
