// Places of the mesh look for the volume, and places of the volume for the mesh.
#include "checking/surface_distances.hpp"

#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "checking/tie_samples.hpp"
#include "checking/tie_surfaces.hpp"
#include "sizing/voxel_rows.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace cleft
{

namespace
{

// Places that a thread takes. The number changes the time alone.
constexpr int64_t kPlacesAtOnce = 1024;

struct Distance {
    TieMaterials of;
    double value;  // infinite: nothing to compare with
    double weight;
};

// Of [begin, end), which it sorts. What is infinite is left out.
DistanceFigures figures_of(Distance* begin, Distance* end)
{
    constexpr double kMost = 0.99;
    DistanceFigures figures;
    end = std::partition(begin, end, [](const Distance& d) { return std::isfinite(d.value); });
    if (begin == end)
        return figures;
    std::sort(begin, end, [](const Distance& a, const Distance& b) {
        return a.value != b.value ? a.value < b.value : a.weight < b.weight;
    });
    double all = 0, sum = 0, so_far = 0;
    for (const Distance* d = begin; d != end; ++d) {
        all += d->weight;
        sum += d->weight * d->value;
    }
    figures.mean = all > 0 ? sum / all : 0;
    figures.greatest = end[-1].value;
    const Distance* at = begin;
    while (at + 1 != end && (so_far += at->weight) < kMost * all)
        ++at;
    figures.most = at->value;
    return figures;
}

using Rows = std::map<TieMaterials, SurfaceDistances>;

// visit(row, begin, end) for each run of distances of the same materials.
template <class Visit>
void for_each_row(Array<Distance>& distances, Rows& rows, const Visit& visit)
{
    for (Distance *begin = distances.data(), *last = begin + distances.size(); begin != last;) {
        Distance* const end = std::find_if(begin, last, [&](const Distance& d) { return d.of != begin->of; });
        SurfaceDistances& row = rows[begin->of];
        row.of = begin->of;
        visit(row, begin, end);
        begin = end;
    }
}

Array<Distance> distances_from_mesh(const TieSurface& surface, const Array<TieSample>& samples,
                                    const Array<Vec3>& points, const Run& run)
{
    Array<Distance> distances(samples.size());
    parallel_with_progress(run, samples.count(), kPlacesAtOnce, [&](int64_t, int64_t begin, int64_t end) {
        Samples scratch;
        for (int64_t i = begin; i < end; ++i)
            distances[i] = {samples[i].of, surface.distance(samples[i].place(points), samples[i].of, scratch),
                            samples[i].weight};
    });
    return distances;
}

Array<Distance> distances_from_volume(const MeshSurface& surface, const Array<TiePoint>& points, const Placement& world,
                                      const Run& run)
{
    Array<Distance> distances(points.size());
    parallel_with_progress(run, points.count(), kPlacesAtOnce, [&](int64_t, int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            distances[i] = {points[i].of, surface.distance(world.to_world(points[i].x), points[i].of), 1};
    });
    return distances;
}

// Of interfaces and of lines, sorted by materials.
Array<TiePoint> tie_points(const Volume& volume, const Run& run)
{
    Array<TiePoint> points = find_interface_points(volume, run);
    const Array<TiePoint> lines = find_line_points(volume, run);
    points.insert(points.end(), lines.begin(), lines.end());
    std::stable_sort(points.begin(), points.end(), [](const TiePoint& a, const TiePoint& b) { return a.of < b.of; });
    return points;
}

// Takes away the points of a material that the mesh lacks: it was lost, or left out as asked.
void keep_met(const LabelledMesh& mesh, Material materials, Array<TiePoint>& points)
{
    Array<uint8_t> is_met(materials, 0);
    for (const Material m : mesh.material)
        is_met[m] = 1;
    const auto is_lacking = [&](const TiePoint& p) {
        return std::any_of(p.of.material.begin(), p.of.material.end(),
                           [&](Material m) { return m != kNoThird && is_met[m] == 0; });
    };
    points.erase(std::remove_if(points.begin(), points.end(), is_lacking), points.end());
}

Array<Vec3> in_world(const Array<Vec3>& points, const Placement& world)
{
    Array<Vec3> out;
    out.reserve(points.size());
    for (const Vec3& x : points)
        out.push_back(world.to_world(x));
    return out;
}

}  // namespace

Array<SurfaceDistances> surface_distances(const Volume& volume, const LabelledMesh& mesh, const Placement& world,
                                          const Run& run)
{
    Steps steps(run, {{"measuring distances", 3}, {nullptr, 5}, {nullptr, 2}});
    const Run of_places = steps.next();
    const Array<TieElement> elements = tie_elements(mesh, of_places);
    Array<TiePoint> points = tie_points(volume, of_places);
    Rows rows;
    {
        const TieSurface surface(volume, points, world);
        Array<Distance> distances =
            distances_from_mesh(surface, tie_samples(elements, mesh.points, world), mesh.points, steps.next());
        for_each_row(distances, rows,
                     [](SurfaceDistances& row, Distance* begin, Distance* end) { row.mesh = figures_of(begin, end); });
    }
    for (const TieElement& element : elements)
        ++rows[element.of].elements;
    keep_met(mesh, volume.material_count(), points);
    const Array<Vec3> world_points = in_world(mesh.points, world);
    const double reach =
        kInterfaceReach * (world.linear * Mat3(volume.grid().spacing.asDiagonal())).colwise().norm().maxCoeff();
    const MeshSurface surface(elements, world_points, reach);
    Array<Distance> distances = distances_from_volume(surface, points, world, steps.next());
    for_each_row(distances, rows, [](SurfaceDistances& row, Distance* begin, Distance* end) {
        row.points = end - begin;
        row.volume = figures_of(begin, end);
    });
    Array<SurfaceDistances> out;
    for (const auto& [of, row] : rows)
        out.push_back(row);
    return out;
}

}  // namespace cleft
