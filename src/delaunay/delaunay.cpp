// Checks the points, and hands them to an engine.
#include "delaunay/delaunay.hpp"

#include "base/ordinal.hpp"
#include "delaunay/brick_delaunay.hpp"
#include "delaunay/perturbed.hpp"
#include "delaunay/tetgen_engine.hpp"
#include "delaunay/widest_tet.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace cleft
{

namespace
{

void check_points(const Array<Vec3>& points)
{
    if (points.size() < 4)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "a Delaunay mesh needs at least 4 points, not " + std::to_string(points.size()));
    if (points.size() > kMostDelaunayPoints)
        throw Error(CLEFT_ERROR_TOO_LARGE,
                    std::to_string(points.size()) + " points are too many for one Delaunay mesh");
    for (size_t i = 0; i < points.size(); ++i)
        if (!points[i].allFinite())
            throw Error(CLEFT_ERROR_NOT_FINITE,
                        "the " + ordinal(static_cast<int64_t>(i)) + " point has a coordinate that is not finite");
}

// Predicates multiply up to five coordinates: keep the products far from overflow and underflow. A power of
// two, so that the scaling is exact.
double safe_scale(const Array<Vec3>& points)
{
    double greatest = 0;
    for (const Vec3& p : points)
        greatest = std::max(greatest, p.cwiseAbs().maxCoeff());
    return greatest > 0 ? std::ldexp(1.0, -std::ilogb(greatest)) : 1;
}

[[noreturn]] void refuse_equal_points(const Array<Vec3>& points)
{
    Array<int32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto less = [&](int32_t a, int32_t b) {
        const Vec3 &x = points[a], &y = points[b];
        return x == y ? a < b : std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    };
    std::sort(order.begin(), order.end(), less);
    int32_t first = INT32_MAX;
    for (size_t i = 1; i < order.size(); ++i)
        if (points[order[i]] == points[order[i - 1]])
            first = std::min(first, order[i]);
    if (first == INT32_MAX)
        throw Error(CLEFT_ERROR_INTERNAL, "a point of the Delaunay mesh was lost");
    throw Error(CLEFT_ERROR_ARGUMENT, "the " + ordinal(first) + " point lies on another point");
}

bool all_used(const Array<Tet>& tets, size_t point_count)
{
    Array<char> used(point_count, 0);
    for (const Tet& tet : tets)
        for (const int32_t v : tet)
            used[v] = 1;
    return std::count(used.begin(), used.end(), 0) == 0;
}

}  // namespace

Array<Tet> delaunay(const Array<Vec3>& points, DelaunayEngine engine, const Run& run)
{
    check_points(points);
    const double scale = safe_scale(points);
    Array<Vec3> scaled(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        scaled[i] = points[i] * scale;
    const std::optional<Tet> first = widest_tet(scaled);
    if (!first)
        throw Error(CLEFT_ERROR_ARGUMENT, "the points lie all in one plane");
    Array<Tet> tets;
    try {
        tets = engine == DelaunayEngine::tetgen ? tetgen_delaunay(scaled, run)
                                                : brick_delaunay(scaled, *first, kPointsInBrick, run);
    } catch (const TwoAtOnePlace&) {
        refuse_equal_points(scaled);
    }
    if (!all_used(tets, points.size()))
        refuse_equal_points(scaled);
    return tets;
}

}  // namespace cleft
