// What each label lacks of the volume of its voxels.
#pragma once

#include "remeshing/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

class VolumeDeficits
{
public:
    // There are none for fields, whose volumes nobody knows.
    VolumeDeficits(const LocalMesh& mesh, const Volume& volume);

    bool empty() const { return missing_.empty(); }
    const std::vector<double>& missing() const { return missing_; }
    void gain(Material m, double volume) { missing_[static_cast<size_t>(m)] -= volume; }

    // Some label is off by so much that another round is worth its time.
    bool is_any_off() const;
    // From now on, interfaces of small labels that are still off may go further beyond the tie.
    void widen();
    bool is_wide(Material m) const { return wide_[static_cast<size_t>(m)] != 0; }

private:
    bool is_off(size_t m, int64_t least_voxels, double tolerance) const;
    bool is_far_off(size_t m) const;

    std::vector<int64_t> voxels_;
    double voxel_;  // its volume
    std::vector<double> missing_;
    std::vector<char> wide_;
};

}  // namespace cleft
