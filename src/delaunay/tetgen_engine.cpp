// Runs TetGen, and makes its tetrahedra positive and canonical.
#include "delaunay/tetgen_engine.hpp"

#ifdef CLEFT_WITH_TETGEN

#include "base/stage.hpp"
#include "delaunay/canonical.hpp"
#include "delaunay/insertion_order.hpp"
#include "delaunay/tet_groups.hpp"
#include "delaunay/tetgen_run.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"

#include <algorithm>
#include <mutex>

namespace cleft
{

namespace
{

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
        if (sign == 0) {
            flat[t] = 1;
            any_flat = true;
        }
    }
    if (any_flat)
        drop_flat_hull_tets(tets, flat, points.count(), run);
    if (std::count(flat.begin(), flat.end(), 1) > 0)
        throw Error(CLEFT_ERROR_INTERNAL, "TetGen returned a flat tetrahedron inside the mesh");
}

}  // namespace

Array<Tet> tetgen_delaunay(const Array<Vec3>& points, const Run& run)
{
    const Array<int32_t> order = insertion_order(points, run);
    Array<Vec3> ordered(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        ordered[i] = points[order[i]];
    Steps steps(run, {{nullptr, 9}, {nullptr, 1}});
    Array<Array<Tet>> tets(1);
    tets[0] = run_tetgen_alone(ordered, steps.next());
    const Run last = steps.next();
    make_positive(tets[0], ordered, last);
    for (Tet& tet : tets[0]) {
        for (int32_t& v : tet)
            v = order[v];
        tet = canonical(tet);
    }
    return grouped(tets, points.count(), last);
}

}  // namespace cleft

#else

#include "base/error.hpp"

namespace cleft
{

Array<Tet> tetgen_delaunay(const Array<Vec3>&, const Run&)
{
    throw Error(CLEFT_ERROR_UNSUPPORTED,
                "this build has no TetGen: choose the Delaunay engine 'cleft', or build with CLEFT_WITH_TETGEN=ON");
}

}  // namespace cleft

#endif
