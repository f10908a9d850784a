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

// In a part of a mesh.
constexpr int64_t kLeastInPart = 20;
constexpr double kToleranceInPart = 0.001;

}  // namespace

VolumeDeficits::VolumeDeficits(const LocalMesh& mesh, const Volume& volume, const Array<double>* volumes,
                               const Run& run)
    : voxel_(volume.grid().spacing.prod())
{
    if (!volume.is_label_map())
        return;
    is_part_ = volumes != nullptr;
    if (volumes)
        wanted_.assign(volumes->begin(), volumes->end());
    else
        for (const int64_t voxels : volume.voxel_counts())
            wanted_.push_back(static_cast<double>(voxels) * voxel_);
    missing_ =
        material_volumes(mesh.points(), mesh.tets(), mesh.materials(), static_cast<Material>(wanted_.size()), run);
    for (size_t m = 0; m < wanted_.size(); ++m)
        missing_[m] = wanted_[m] - missing_[m];
    wide_.resize(missing_.size(), 0);
}

bool VolumeDeficits::is_off(size_t m, int64_t least_voxels, double tolerance) const
{
    return wanted_[m] > static_cast<double>(least_voxels) * voxel_ && std::abs(missing_[m]) > tolerance * wanted_[m];
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
        // What parts of a mesh leave undone adds up.
        if (is_off(m, is_part_ ? kLeastInPart : kLargeLabel, is_part_ ? kToleranceInPart : kTolerance))
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
