// Pulls each point by the edges at it, one sweep at a time.
#include "remeshing/springs.hpp"

#include "base/per_worker.hpp"
#include "mesh/adjacency.hpp"
#include "remeshing/edge_length.hpp"
#include "remeshing/point_visits.hpp"
#include "remeshing/smoothing.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Each edge pulls in three dimensions, but can be made right along its own alone. So the mean pull of all edges is
// three times too small to make them right.
constexpr double kDimensions = 3;
// The length at which a spring is at rest. See kShortest.
constexpr double kRest = 0.97;

// Where the springs at the point pull it.
Vec3 pull(const LocalMesh& mesh, int32_t v, Array<int32_t>& around)
{
    around.clear();
    for (const int32_t t : mesh.star(v))
        for (const int32_t w : mesh.tet(t))
            if (w != v)
                around.push_back(w);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    Vec3 sum(0, 0, 0);
    for (const int32_t w : around)
        sum += (1 - kRest / edge_length(mesh, v, w)) * (mesh.point(w) - mesh.point(v));
    return kDimensions / static_cast<double>(around.size()) * sum;
}

// False where there is no tetrahedron at all.
bool is_in_one_material(const LocalMesh& mesh, int32_t v)
{
    const auto star = mesh.star(v);
    return !star.empty() && std::all_of(star.begin(), star.end(),
                                        [&](int32_t t) { return mesh.material(t) == mesh.material(*star.begin()); });
}

}  // namespace

void relax_springs(LocalMesh& mesh, double floor, const Run& run)
{
    mesh.find_qualities(run);
    PerWorker<Array<int32_t>> rooms(run);
    const auto is_free = [&](int32_t v) { return mesh.frozen(v) != 7 && is_in_one_material(mesh, v); };
    PointVisits(mesh, run).visit(is_free, [&](int worker, int32_t v) {
        const Vec3 shift = free_axes(mesh.frozen(v)) * pull(mesh, v, rooms[worker]);
        double before = 1;
        for (const int32_t t : mesh.star(v))
            before = std::min(before, mesh.quality(t));
        const double least = std::min(before, floor);
        for (const double part : {1.0, 0.5, 0.25})
            if (const Vec3 to = mesh.point(v) + part * shift; mesh.worst_with(v, to) > least) {
                mesh.move(v, to);
                return;
            }
    });
}

}  // namespace cleft
