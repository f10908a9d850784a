// Warns where the volume of a label is off by so much that a user should know. An example is a part that is thinner
// than the tetrahedra.
#include "finishing/volume_differences.hpp"

#include "base/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace cleft
{

namespace
{

constexpr int64_t kLeastVoxels = 100;  // the volume of fewer is not known to a few percent
// docs/quality.md: on graded backgrounds labels of this size are within a percent as a rule. Shells one voxel thick may
// be off by as much as this.
constexpr double kMostDifference = 0.05;

struct Difference {
    UserLabel label;
    double share;  // of the volume of the voxels
};

// "label 3 (+12 %)"
std::string text(const Difference& difference)
{
    const std::string sign = difference.share >= 0 ? "+" : "";
    return name_of(difference.label) + " (" + sign + digits_text(100 * difference.share, 3) + " %)";
}

// The comparison makes no sense where a background of the user fills only a part of the box.
bool fills_box(const Grid& grid, const Array<double>& volumes)
{
    const double box = grid.extent().prod();
    return std::abs(std::accumulate(volumes.begin(), volumes.end(), 0.0) - box) < 1e-6 * box;
}

// Those that differ too much, the greatest difference first.
Array<Difference> differences(const Grid& grid, const LabelCounts& of, const Array<double>& volumes,
                              const KeptMaterials& kept)
{
    Array<Difference> all;
    for (size_t m = 0; m < of.voxels.size(); ++m) {
        if (of.voxels[m] < kLeastVoxels || !kept.has(static_cast<Material>(m)))
            continue;
        const double share = volumes[m] / (static_cast<double>(of.voxels[m]) * grid.spacing.prod()) - 1;
        if (std::abs(share) > kMostDifference)
            all.push_back({of.labels[m], share});
    }
    // Equal differences stay in the order of the materials.
    std::stable_sort(all.begin(), all.end(),
                     [](const Difference& a, const Difference& b) { return std::abs(a.share) > std::abs(b.share); });
    return all;
}

}  // namespace

void warn_of_volume_differences(const Grid& grid, const LabelCounts& voxels, const Array<double>& volumes,
                                const KeptMaterials& kept, const Run& run)
{
    // A sentence that names more is not read.
    constexpr size_t kNamed = 5;
    if (!run.on_warning || !fills_box(grid, volumes))
        return;
    const Array<Difference> all = differences(grid, voxels, volumes, kept);
    if (all.empty())
        return;
    std::string names;
    for (size_t i = 0; i < std::min(all.size(), kNamed); ++i)
        names += (i == 0 ? "" : ", ") + text(all[i]);
    if (all.size() > kNamed)
        names += " and " + std::to_string(all.size() - kNamed) + " more";
    run.warn((all.size() == 1 ? std::string("the volume of one label differs")
                              : "the volumes of " + std::to_string(all.size()) + " labels differ") +
             " by more than " + digits_text(100 * kMostDifference, 3) + " % from that of the voxels: " + names);
}

}  // namespace cleft
