// Looks for the widest triangle, and for a point off it.
#include "delaunay/widest_tet.hpp"

#include "mesh/predicates.hpp"

namespace cleft
{

std::optional<Tet> widest_tet(const Array<Vec3>& points)
{
    const auto greatest = [&](const auto& measure) {
        int32_t best = 0;
        double most = measure(points[0]);
        for (int32_t i = 1; i < points.count(); ++i) {
            const double m = measure(points[i]);
            if (m > most) {
                most = m;
                best = i;
            }
        }
        return best;
    };
    const Vec3& a = points[0];
    const int32_t b = greatest([&](const Vec3& p) { return (p - a).squaredNorm(); });
    const Vec3 line = points[b] - a;
    const int32_t c = greatest([&](const Vec3& p) { return (p - a).cross(line).squaredNorm(); });
    for (int32_t d = 0; d < points.count(); ++d)
        if (orient_sign(a, points[b], points[c], points[d]) != 0)
            return Tet{{0, b, c, d}};
    return std::nullopt;
}

}  // namespace cleft
