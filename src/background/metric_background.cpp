// Makes the background in a stretched box, or adapts one of particles.
#include "background/metric_background.hpp"

#include "background/adapt.hpp"
#include "base/number_text.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "mesh/materials.hpp"
#include "sizing/metric_sizing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace cleft
{

namespace
{

// Points that a thread takes. The number changes the time alone.
constexpr int64_t kPointsAtOnce = 1 << 14;

// About as many as particles can have.
constexpr double kMostTetsOfMetric = 360e6;

// The sizes along the axes of a metric that has these axes and is the same everywhere.
std::optional<Vec3> sizes_along_axes(const MetricField& metric)
{
    const auto& l = metric.log.front();
    if (l[1] != 0 || l[2] != 0 || l[4] != 0 ||
        std::any_of(metric.log.begin(), metric.log.end(), [&](const auto& other) { return other != l; }))
        return std::nullopt;
    return Vec3(std::exp(-0.5 * double{l[0]}), std::exp(-0.5 * double{l[3]}), std::exp(-0.5 * double{l[5]}));
}

// Where all sizes are the mean size. What lies on a plane of the box comes back to it exactly.
TetMesh in_stretched_box(const SizingField& field, const Vec3& sizes, const BackgroundOptions& options, const Run& run)
{
    const double size = double{field.h.front()};
    SizingField stretched{field.grid, Array<float>(field.h), field.gradation};
    for (int axis = 0; axis < 3; ++axis)
        stretched.grid.spacing[axis] *= size / sizes[axis];
    TetMesh mesh = row_of(options.kind).make(stretched, options, run);
    const Vec3 from = stretched.grid.extent(), to = field.grid.extent();
    parallel_for(run, mesh.points.count(), kPointsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v)
            for (int axis = 0; axis < 3; ++axis) {
                double& x = mesh.points[v][axis];
                x = x == from[axis] ? to[axis] : std::min(to[axis], x * (to[axis] / from[axis]));
            }
    });
    return mesh;
}

double possible_tets(double expected)
{
    if (!(expected < kMostTetsOfMetric))
        throw Error(CLEFT_ERROR_TOO_LARGE, "the metric asks for about " + count_text(expected) +
                                               " tetrahedra; a background can have " + count_text(kMostTetsOfMetric));
    return expected;
}

}  // namespace

TetMesh metric_background(const SizingField& field, const BackgroundOptions& options, const Run& run)
{
    if (const auto sizes = sizes_along_axes(*field.metric))
        return in_stretched_box(field, *sizes, options, run);
    if (options.kind != BackgroundKind::particles)
        throw Error(CLEFT_ERROR_OPTION,
                    "a lattice or an octree follows a metric only if it is the same everywhere and has the axes of the "
                    "voxels; set the background to particles");
    const double expected = possible_tets(expected_particle_tets(field));
    Steps steps(run, {{nullptr, 20}, {nullptr, 80}});
    const Run of_start = steps.next();
    TetMesh mesh = particle_background(greatest_sizes(field, of_start), options.particles, of_start);
    adapt(mesh, *field.metric, expected, MadeOf::greatest_sizes, steps.next());
    return mesh;
}

void adapt_to_metric(TetMesh& mesh, const SizingField& field, const Run& run)
{
    const double volume =
        material_volumes(mesh.points, mesh.tets, Array<Material>(mesh.tets.size(), 0), 1, run).front();
    const double boxes = std::max(1.0, volume / field.grid.extent().prod());
    adapt(mesh, *field.metric, possible_tets(boxes * expected_particle_tets(field)), MadeOf::any_sizes, run);
}

}  // namespace cleft
