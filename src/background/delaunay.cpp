// Delaunay tetrahedra by TetGen, with all checks around it that TetGen does not make (decision 8).
#include "background/delaunay.hpp"

#ifdef CLEFT_WITH_TETGEN

#include "background/insertion_order.hpp"
#include "background/tetgen_run.hpp"
#include "base/large_pages.hpp"
#include "base/ordinal.hpp"
#include "base/stage.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
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

// Three corners of the widest triangle met, then any point off its plane (exactly).
// TetGen asserts that points are not in one plane, and a failed assertion would end the program.
bool all_in_one_plane(const Array<Vec3>& points)
{
    const Vec3& a = points[0];
    const auto farthest = [&](const auto& measure) {
        size_t best = 0;
        for (size_t i = 1; i < points.size(); ++i)
            if (measure(points[i]) > measure(points[best]))
                best = i;
        return points[best];
    };
    const Vec3 b = farthest([&](const Vec3& p) { return (p - a).squaredNorm(); });
    const Vec3 c = farthest([&](const Vec3& p) { return (p - a).cross(b - a).squaredNorm(); });
    for (const Vec3& p : points)
        if (orient_sign(a, b, c, p) != 0)
            return false;
    return true;
}

// TetGen's predicates multiply up to five coordinates: keep the products far from overflow and underflow. A power of
// two, so that the scaling is exact.
double safe_scale(const Array<Vec3>& points)
{
    double greatest = 0;
    for (const Vec3& p : points)
        greatest = std::max(greatest, p.cwiseAbs().maxCoeff());
    return greatest > 0 ? std::ldexp(1.0, -std::ilogb(greatest)) : 1;
}

// TetGen keeps its error bounds in global variables.
Array<Tet> run_tetgen_alone(Array<Vec3>& scaled, const Run& run)
{
    // Users may mesh in several threads, each with a context of its own. Here they wait for each other.
    static std::mutex one_at_a_time;
    const std::lock_guard<std::mutex> lock(one_at_a_time);
    run.check();
    return run_tetgen(scaled);
}

// Cospherical points in a plane of the hull may be joined by a tetrahedron of no volume that lies in that plane.
// Without it the hull stays the same set of points.
void drop_flat_hull_tets(Array<Tet>& tets, Array<char>& flat, int64_t point_count, const Run& run)
{
    const Array<FixedArray<int32_t, 4>> neighbours = tet_neighbours(tets, point_count, run);
    Array<int64_t> hull;
    Array<char> dropped(tets.size(), 0);
    const auto visit = [&](int64_t t) {
        if (flat[t] && !dropped[t]) {
            dropped[t] = 1;
            hull.push_back(t);
        }
    };
    for (int64_t t = 0; t < tets.count(); ++t)
        if (std::count(neighbours[t].begin(), neighbours[t].end(), -1) > 0)
            visit(t);
    while (!hull.empty()) {
        const int64_t t = hull.back();
        hull.pop_back();
        for (const int32_t n : neighbours[t])
            if (n >= 0)
                visit(n);
    }
    size_t kept = 0;
    for (size_t t = 0; t < tets.size(); ++t)
        if (!dropped[t]) {
            flat[kept] = flat[t];
            tets[kept++] = tets[t];
        }
    tets.resize(kept);
    flat.resize(kept);
}

void make_positive(Array<Tet>& tets, const Array<Vec3>& points, const Run& run)
{
    Array<char> flat(tets.size(), 0);
    bool any_flat = false;
    for (size_t t = 0; t < tets.size(); ++t) {
        const Tet& v = tets[t];
        const auto corner = [&](size_t i) -> const Vec3& { return points[v[i]]; };
        const int sign = orient_sign(corner(0), corner(1), corner(2), corner(3));
        // All stages that follow rely on positive tetrahedra. A wrong one is reported here, where its cause is known.
        if (sign < 0)
            throw Error(CLEFT_ERROR_INTERNAL, "TetGen returned an inverted tetrahedron");
        flat[t] = sign == 0;
        any_flat = any_flat || sign == 0;
    }
    if (any_flat)
        drop_flat_hull_tets(tets, flat, points.count(), run);
    if (std::count(flat.begin(), flat.end(), 1) > 0)
        throw Error(CLEFT_ERROR_INTERNAL, "TetGen returned a flat tetrahedron inside the mesh");
}

// TetGen's order is that of its insertions, all over the box. Where the points are in a spatial order, so are the
// tetrahedra after this, and the stages that follow find in the cache what they need.
Array<Tet> by_least_point(const Array<Tet>& tets, size_t point_count)
{
    const auto key = [](const Tet& tet) { return *std::min_element(tet.begin(), tet.end()); };
    Array<size_t> begin(point_count + 1, 0);
    for (const Tet& tet : tets)
        ++begin[key(tet) + 1];
    for (size_t v = 0; v < point_count; ++v)
        begin[v + 1] += begin[v];
    Array<Tet> sorted = large_array<Tet>(tets.size());
    for (const Tet& tet : tets)
        sorted[begin[key(tet)]++] = tet;
    return sorted;
}

void check_all_used(const Array<Tet>& tets, size_t point_count)
{
    Array<char> used(point_count, 0);
    for (const Tet& tet : tets)
        for (const int32_t v : tet)
            used[v] = 1;
    const auto unused = std::find(used.begin(), used.end(), 0) - used.begin();
    if (unused < used.count())
        throw Error(CLEFT_ERROR_ARGUMENT, "the " + ordinal(unused) + " point lies on another point");
}

}  // namespace

Array<Tet> delaunay(const Array<Vec3>& points, const Run& run)
{
    check_points(points);
    const double scale = safe_scale(points);
    const Array<int32_t> order = insertion_order(points, run);
    Array<Vec3> scaled(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        scaled[i] = points[order[i]] * scale;
    if (all_in_one_plane(scaled))
        throw Error(CLEFT_ERROR_ARGUMENT, "the points lie all in one plane");
    Steps steps(run, {{nullptr, 9}, {nullptr, 1}});
    Array<Tet> tets = run_tetgen_alone(scaled, steps.next());
    make_positive(tets, scaled, steps.next());
    for (Tet& tet : tets)
        for (int32_t& v : tet)
            v = order[v];
    check_all_used(tets, points.size());
    tets = by_least_point(tets, points.size());
    return tets;
}

}  // namespace cleft

#else

namespace cleft
{

Array<Tet> delaunay(const Array<Vec3>&, const Run&)
{
    throw Error(
        CLEFT_ERROR_UNSUPPORTED,
        "this build has no TetGen: choose the background 'octree' or 'lattice', or build with CLEFT_WITH_TETGEN=ON");
}

}  // namespace cleft

#endif
