// Counts the tetrahedra with angles beyond the target and names the worst of them.
#include "pipeline/missed_angles.hpp"

#include "base/counted.hpp"
#include "base/degrees.hpp"
#include "base/number_text.hpp"
#include "mesh/quality.hpp"
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
};

MissedAngles missed_angles(const LabelledMesh& mesh, const PipelineOptions& options, const Run& run)
{
    MissedAngles missed;
    const double least_quality = sine_of(options.improve.target_angle) * (1 - kRounding);
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        run.check_at(static_cast<int64_t>(t));
        if (!options.kept.has(mesh.material[t]))
            continue;
        const auto corner = [&](size_t i) -> const Vec3& { return mesh.points[mesh.tets[t][i]]; };
        // The quality needs no arc cosine, and few tetrahedra come further than this.
        if (angle_quality(corner(0), corner(1), corner(2), corner(3)) >= least_quality)
            continue;
        const auto angles = dihedral_angles(corner(0), corner(1), corner(2), corner(3));
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        ++missed.tets;
        missed.least = std::min(missed.least, *low);
        missed.greatest = std::max(missed.greatest, *high);
    }
    return missed;
}

}  // namespace

void warn_of_missed_angles(const Volume& volume, const LabelledMesh& mesh, const PipelineOptions& options,
                           const Run& run)
{
    // Who leaves out improving knows that angles will be bad, and without a caller for warnings there is nobody to
    // tell.
    if (!run.on_warning || options.improve.effort == Effort::off)
        return;
    const MissedAngles missed = missed_angles(mesh, options, run);
    if (missed.tets == 0)
        return;
    const Vec3 spacing = volume.grid().spacing;
    const double stretch = spacing.maxCoeff() / spacing.minCoeff();
    run.warn(counted(missed.tets, "tetrahedron has", "tetrahedra have") + " dihedral angles below " +
             number_text(options.improve.target_angle) + " or above " + number_text(kGreatestAngle) +
             " degrees, from " + decimals_text(missed.least, 1) + " to " + decimals_text(missed.greatest, 1) +
             (stretch > kUsualStretch ? "; the voxel spacings differ by a factor of " + digits_text(stretch, 3) : ""));
}

}  // namespace cleft
