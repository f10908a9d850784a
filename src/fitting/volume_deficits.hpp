// What each label lacks of the volume of its voxels.
#pragma once

#include "base/array.hpp"
#include "remeshing/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

class VolumeDeficits
{
public:
    // There are none for fields, whose volumes nobody knows.
    // `volumes`: what each material is to have; null: the volume of its voxels.
    VolumeDeficits(const LocalMesh& mesh, const Volume& volume, const Array<double>* volumes, const Run& run);

    bool empty() const { return missing_.empty(); }
    const Array<double>& missing() const { return missing_; }
    void gain(Material m, double volume) { missing_[m] -= volume; }

    // Some label is off by so much that another round is worth its time.
    bool is_any_off() const;
    // A label of more than some voxels is off by several percent.
    bool is_any_far_off() const;
    // From now on, interfaces of small labels that are still off may go further beyond the tie.
    void widen();
    bool is_wide(Material m) const { return wide_[m] != 0; }

private:
    bool is_off(size_t m, int64_t least_voxels, double tolerance) const;
    bool is_far_off(size_t m) const;

    double voxel_;          // the volume of one
    Array<double> wanted_;  // by material
    bool is_part_ = false;
    Array<double> missing_;
    Array<char> wide_;
};

}  // namespace cleft
