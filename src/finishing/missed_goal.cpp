// Counts the tetrahedra whose angles or radius ratio are beyond the goal and names the worst of them.
#include "finishing/missed_goal.hpp"

#include "base/counted.hpp"
#include "base/degrees.hpp"
#include "base/number_text.hpp"
#include "base/parallel.hpp"
#include "mesh/shape_qualities.hpp"
#include "volume/limits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cleft
{

namespace
{

// Improving leaves no angle nearer to its target than by this share, but for rounding.
constexpr double kRounding = 1e-6;

// The goal, a little lower for the rounding.
struct Goal {
    double quality, ratio;
};

Goal goal_of(double target) { return {sine_of(target) * (1 - kRounding), greatest_ratio(target) * (1 + kRounding)}; }

void add_if_missed(const std::array<Vec3, 4>& x, const MetricField* metric, const Goal& goal, MissedGoal& out)
{
    const Vec3 centroid = (x[0] + x[1] + x[2] + x[3]) / 4;
    const auto y = metric ? measured(x, *metric) : x;
    const double quality = angle_quality(y[0], y[1], y[2], y[3]), ratio = radius_ratio(y[0], y[1], y[2], y[3]);
    if (quality < goal.quality) {
        const auto found = dihedral_angles(y[0], y[1], y[2], y[3]);
        const auto [low, high] = std::minmax_element(found.begin(), found.end());
        out.least = std::min(out.least, *low);
        out.greatest = std::max(out.greatest, *high);
        out.angles.join({1, quality, centroid});
    } else if (ratio > goal.ratio) {
        out.ratios.join({1, 1 / ratio, centroid});
    }
}

std::array<Vec3, 4> corners_of(const LabelledMesh& mesh, int64_t t)
{
    const Tet& tet = mesh.tets[t];
    return {mesh.points[tet[0]], mesh.points[tet[1]], mesh.points[tet[2]], mesh.points[tet[3]]};
}

// Of the tetrahedra from `begin` to before `end`. It needs no arc cosine, and few come further than this.
Array<double> qualities_of(const LabelledMesh& mesh, const MetricField* metric, int64_t begin, int64_t end)
{
    Array<double> qualities(end - begin);
    if (metric) {
        for (int64_t t = begin; t < end; ++t) {
            const auto x = measured(corners_of(mesh, t), *metric);
            qualities[t - begin] = shape_quality(x[0], x[1], x[2], x[3]);
        }
        return qualities;
    }
    Foursome four;
    for (int64_t t = begin; t < end; ++t)
        if (four.add(t - begin, mesh.tets[t], mesh.points))
            four.measure(qualities);
    four.measure(qualities);
    return qualities;
}

// "(12, 0, 7)": the indices of the voxel along the axes of the volume, from 0. They need no frame.
std::string voxel_text(const Vec3& x, const Grid& grid)
{
    std::string text;
    for (int a = 0; a < 3; ++a) {
        const auto index = static_cast<int64_t>(x[a] / grid.spacing[a]);
        text += (a ? ", " : "(") + std::to_string(std::min<int64_t>(index, grid.dims[a] - 1));
    }
    return text + ")";
}

// And what is known to be in the way.
std::string place_text(const Missed& missed, const Grid& grid, const PipelineOptions& options)
{
    const double stretch = grid.spacing.maxCoeff() / grid.spacing.minCoeff();
    return ", the worst in voxel " + voxel_text(missed.worst, grid) +
           (stretch > kUsualStretch ? "; the voxel spacings differ by a factor of " + digits_text(stretch, 3) : "") +
           (options.of_world ? "; the affine shears the voxels" : "");
}

}  // namespace

bool tells_of_missed_goal(const PipelineOptions& options, int32_t ranks, const Run& run)
{
    return options.improve.effort != Effort::off && (run.on_warning || run.metrics || ranks > 1);
}

void Missed::join(const Missed& next)
{
    if (next.least_quality < least_quality) {
        least_quality = next.least_quality;
        worst = next.worst;
    }
    tets += next.tets;
}

void MissedGoal::join(const MissedGoal& next)
{
    angles.join(next.angles);
    ratios.join(next.ratios);
    least = std::min(least, next.least);
    greatest = std::max(greatest, next.greatest);
}

MissedGoal missed_goal(const LabelledMesh& mesh, const PipelineOptions& options, const Run& run)
{
    constexpr int64_t kTetsAtOnce = 4096;
    const MetricField* metric = options.of_world ? options.of_world.get() : options.cleave.metric;
    const Goal goal = goal_of(target_angle(options.improve));
    Array<MissedGoal> parts(chunk_count(mesh.tets.count(), kTetsAtOnce));
    parallel_chunks(run, mesh.tets.count(), kTetsAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        const Array<double> qualities = qualities_of(mesh, metric, begin, end);
        for (int64_t t = begin; t < end; ++t)
            if (qualities[t - begin] < goal.quality && options.kept.has(mesh.material[t]))
                add_if_missed(corners_of(mesh, t), metric, goal, parts[chunk]);
    });
    MissedGoal missed;
    for (const MissedGoal& part : parts)
        missed.join(part);
    return missed;
}

void warn_of_missed_goal(const MissedGoal& missed, const Grid& grid, const PipelineOptions& options, const Run& run)
{
    const double target = target_angle(options.improve);
    run.note("improving.target_angle", target);
    run.note("improving.tets_missed", static_cast<double>(missed.angles.tets));
    run.note("improving.ratios_missed", static_cast<double>(missed.ratios.tets));
    if (missed.angles.tets > 0)
        run.warn(counted(missed.angles.tets, "tetrahedron has", "tetrahedra have") + " dihedral angles below " +
                 number_text(target) + " or above " + decimals_text(greatest_angle(target), 1) + " degrees, from " +
                 decimals_text(missed.least, 1) + " to " + decimals_text(missed.greatest, 1) +
                 place_text(missed.angles, grid, options));
    if (missed.ratios.tets > 0)
        run.warn(counted(missed.ratios.tets, "tetrahedron has a radius ratio", "tetrahedra have radius ratios") +
                 " above " + decimals_text(greatest_ratio(target), 1) + ", up to " +
                 decimals_text(1 / missed.ratios.least_quality, 1) + place_text(missed.ratios, grid, options));
}

}  // namespace cleft
