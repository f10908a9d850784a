// Which labels are still off, and how far.
#include "fitting/volume_deficits.hpp"

#include "mesh/materials.hpp"

#include <cmath>

namespace cleft
{

namespace
{

// Another round is worth its time while a label of more voxels than these is off by more than this share. A label that
// is hardly thicker than the steps of its interface gets near its volume over several rounds.
constexpr int64_t kLargeLabel = 1000;
constexpr double kTolerance = 0.003;
// And while one of more voxels than these, such as a shell, is off by this share.
// A greater number would leave small shells as they are. A smaller one would make rounds for labels of a few voxels.
constexpr int64_t kSmallLabel = 60;
constexpr double kWideTolerance = 0.03;

}  // namespace

VolumeDeficits::VolumeDeficits(const LocalMesh& mesh, const Volume& volume, const Run& run)
    : voxel_(volume.grid().spacing.prod())
{
    if (!volume.is_label_map())
        return;
    voxels_ = volume.voxel_counts();
    missing_ =
        material_volumes(mesh.points(), mesh.tets(), mesh.materials(), static_cast<Material>(voxels_.size()), run);
    for (size_t m = 0; m < voxels_.size(); ++m)
        missing_[m] = static_cast<double>(voxels_[m]) * voxel_ - missing_[m];
    wide_.resize(missing_.size(), 0);
}

bool VolumeDeficits::is_off(size_t m, int64_t least_voxels, double tolerance) const
{
    return voxels_[m] > least_voxels && std::abs(missing_[m]) > tolerance * (static_cast<double>(voxels_[m]) * voxel_);
}

bool VolumeDeficits::is_far_off(size_t m) const { return is_off(m, kSmallLabel, kWideTolerance); }

bool VolumeDeficits::is_any_far_off() const
{
    for (size_t m = 0; m < missing_.size(); ++m)
        if (is_far_off(m))
            return true;
    return false;
}

bool VolumeDeficits::is_any_off() const
{
    for (size_t m = 0; m < missing_.size(); ++m)
        if (is_off(m, kLargeLabel, kTolerance))
            return true;
    return is_any_far_off();
}

void VolumeDeficits::widen()
{
    for (size_t m = 0; m < wide_.size(); ++m)
        if (is_far_off(m))
            wide_[m] = 1;
}

}  // namespace cleft
