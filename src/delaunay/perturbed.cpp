// Decides on which side of a sphere a point lies, by the numbers of the points where it lies on it.
#include "delaunay/perturbed.hpp"

#include "mesh/predicates.hpp"

#include <algorithm>

namespace cleft
{

bool inside_perturbed_sphere(const FixedArray<NumberedPoint, 4>& tet, const NumberedPoint& e)
{
    FixedArray<const Vec3*, 4> x;
    for (int i = 0; i < 4; ++i)
        x[i] = tet[i].x;
    const int sign = in_sphere_sign(*x[0], *x[1], *x[2], *x[3], *e.x);
    if (sign != 0)
        return sign > 0;
    for (const NumberedPoint& corner : tet)
        if (*corner.x == *e.x)
            throw TwoAtOnePlace();
    // e is above the plane of the raised tetrahedron by its own rise less those of the corners, each times its
    // barycentric coordinate at e. The greatest rise with a coordinate that is not zero decides.
    FixedArray<int, 4> order{{0, 1, 2, 3}};
    std::sort(order.begin(), order.end(), [&](int i, int j) { return tet[i].number > tet[j].number; });
    for (const int i : order) {
        if (tet[i].number < e.number)
            return false;
        FixedArray<const Vec3*, 4> replaced = x;
        replaced[i] = e.x;
        const int coordinate = orient_sign(*replaced[0], *replaced[1], *replaced[2], *replaced[3]);
        if (coordinate != 0)
            return coordinate > 0;
    }
    return false;
}

}  // namespace cleft
