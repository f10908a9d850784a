// Counts the tetrahedra with angles beyond the target and names the worst of them.
#include "pipeline/missed_angles.hpp"

#include "base/counted.hpp"
#include "base/degrees.hpp"
#include "base/number_text.hpp"
#include "base/parallel.hpp"
#include "mesh/angle_qualities.hpp"
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

struct MissedAngles {
    int64_t tets = 0;
    double least = 180, greatest = 0;
    double least_quality = 1;
    Vec3 worst = Vec3::Zero();  // the centroid of the first tetrahedron of that quality

    void add(const std::array<Vec3, 4>& x, const MetricField* metric, double quality)
    {
        const auto y = metric ? measured(x, *metric) : x;
        const auto angles = dihedral_angles(y[0], y[1], y[2], y[3]);
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        join({1, *low, *high, quality, (x[0] + x[1] + x[2] + x[3]) / 4});
    }

    void join(const MissedAngles& next)
    {
        if (next.least_quality < least_quality) {
            least_quality = next.least_quality;
            worst = next.worst;
        }
        tets += next.tets;
        least = std::min(least, next.least);
        greatest = std::max(greatest, next.greatest);
    }
};

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
            qualities[t - begin] = angle_quality(x[0], x[1], x[2], x[3]);
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

MissedAngles missed_angles(const LabelledMesh& mesh, const MetricField* metric, double target,
                           const KeptMaterials& kept, const Run& run)
{
    constexpr int64_t kTetsAtOnce = 4096;
    const double least_quality = sine_of(target) * (1 - kRounding);
    Array<MissedAngles> parts(chunk_count(mesh.tets.count(), kTetsAtOnce));
    parallel_chunks(run, mesh.tets.count(), kTetsAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        const Array<double> qualities = qualities_of(mesh, metric, begin, end);
        for (int64_t t = begin; t < end; ++t)
            if (qualities[t - begin] < least_quality && kept.has(mesh.material[t]))
                parts[chunk].add(corners_of(mesh, t), metric, qualities[t - begin]);
    });
    MissedAngles missed;
    for (const MissedAngles& part : parts)
        missed.join(part);
    return missed;
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

}  // namespace

void warn_of_missed_angles(const Volume& volume, const LabelledMesh& mesh, const PipelineOptions& options,
                           const Run& run)
{
    // Who leaves out improving knows that angles will be bad, and without a caller for warnings or figures there is
    // nobody to tell.
    if (options.improve.effort == Effort::off || (!run.on_warning && !run.metrics))
        return;
    const double target = target_angle(options.improve);
    const MissedAngles missed = missed_angles(mesh, options.cleave.metric, target, options.kept, run);
    run.note("improving.target_angle", target);
    run.note("improving.tets_missed", static_cast<double>(missed.tets));
    if (missed.tets == 0)
        return;
    const Vec3 spacing = volume.grid().spacing;
    const double stretch = spacing.maxCoeff() / spacing.minCoeff();
    run.warn(counted(missed.tets, "tetrahedron has", "tetrahedra have") + " dihedral angles below " +
             number_text(target) + " or above " + decimals_text(greatest_angle(target), 1) + " degrees, from " +
             decimals_text(missed.least, 1) + " to " + decimals_text(missed.greatest, 1) + ", the worst in voxel " +
             voxel_text(missed.worst, volume.grid()) +
             (stretch > kUsualStretch ? "; the voxel spacings differ by a factor of " + digits_text(stretch, 3) : ""));
}

}  // namespace cleft
