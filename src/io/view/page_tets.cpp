// Chooses what a page shows of a large mesh. The layer at the interfaces comes first, as it has the shape of all
// materials. If that is too much, too, the middle of it is shown whole instead of the whole with holes.
#include "io/view/page_tets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cleft::io
{

namespace
{

std::vector<char> points_of_surface(const MeshView& mesh, const cleft_surface* surface)
{
    std::vector<char> is_there(static_cast<size_t>(mesh.point_count), 0);
    const auto mark = [&](const int32_t* corners, int64_t triangles) {
        for (int64_t i = 0; i < 3 * triangles; ++i)
            is_there[static_cast<size_t>(corners[i])] = 1;
    };
    mark(cleft_surface_interface_triangles(surface), cleft_surface_interface_count(surface));
    mark(cleft_surface_hull_triangles(surface), cleft_surface_hull_count(surface));
    return is_there;
}

std::vector<int64_t> tets_at_surface(const MeshView& mesh, const cleft_surface* surface, const Run& run)
{
    const std::vector<char> is_there = points_of_surface(mesh, surface);
    std::vector<int64_t> tets;
    for (int64_t t = 0; t < mesh.tet_count; ++t) {
        run.check_at(t);
        int corners = 0;
        for (int64_t c = 0; c < 4; ++c)
            corners += is_there[static_cast<size_t>(mesh.tets[4 * t + c])];
        // A face has three.
        if (corners >= 3)
            tets.push_back(t);
    }
    return tets;
}

// 0 at the centre of the box of the mesh, 1 at its sides.
double distance_from_middle(const MeshView& mesh, const MeshFigures& figures, int64_t tet)
{
    const Corners corners = corners_of(mesh, tet);
    double greatest = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
        const double centre = (corners[0][axis] + corners[1][axis] + corners[2][axis] + corners[3][axis]) / 4;
        const double half = (figures.high[axis] - figures.low[axis]) / 2;
        if (half > 0)
            greatest = std::max(greatest, std::abs(centre - figures.low[axis] - half) / half);
    }
    return greatest;
}

void keep_middle(const MeshView& mesh, const MeshFigures& figures, int64_t limit, const Run& run,
                 std::vector<int64_t>& tets)
{
    std::vector<std::pair<double, int64_t>> by_distance;
    by_distance.reserve(tets.size());
    for (const int64_t t : tets) {
        run.check_at(t);
        by_distance.emplace_back(distance_from_middle(mesh, figures, t), t);
    }
    std::nth_element(by_distance.begin(), by_distance.begin() + limit, by_distance.end());
    run.check();
    by_distance.resize(static_cast<size_t>(limit));
    tets.clear();
    for (const auto& [distance, t] : by_distance)
        tets.push_back(t);
    std::sort(tets.begin(), tets.end());
}

std::vector<int32_t> points_of(const MeshView& mesh, const std::vector<int64_t>& tets, const Run& run)
{
    std::vector<char> is_used(static_cast<size_t>(mesh.point_count), 0);
    for (size_t i = 0; i < tets.size(); ++i) {
        run.check_at(i);
        for (int64_t c = 0; c < 4; ++c)
            is_used[static_cast<size_t>(mesh.tets[4 * tets[i] + c])] = 1;
    }
    std::vector<int32_t> points;
    for (size_t p = 0; p < is_used.size(); ++p)
        if (is_used[p])
            points.push_back(static_cast<int32_t>(p));
    return points;
}

}  // namespace

PageTets choose_tets(const MeshView& mesh, const cleft_surface* surface, const MeshFigures& figures, int64_t limit,
                     const Run& run)
{
    PageTets shown;
    if (mesh.tet_count > limit && surface) {
        shown.reduction = Reduction::kInterfaces;
        shown.tets = tets_at_surface(mesh, surface, run);
    } else {
        shown.tets.resize(static_cast<size_t>(mesh.tet_count));
        std::iota(shown.tets.begin(), shown.tets.end(), 0);
    }
    if (static_cast<int64_t>(shown.tets.size()) > limit) {
        shown.reduction = Reduction::kMiddle;
        keep_middle(mesh, figures, limit, run, shown.tets);
    }
    shown.points = points_of(mesh, shown.tets, run);
    return shown;
}

}  // namespace cleft::io
