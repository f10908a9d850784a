// The input of every run: a label map or K indicator functions on a grid, sampled at any point.
//
// Positions are in the local frame of Grid. A point outside the box is sampled at the nearest point of the box.
// A finished Volume is immutable; all const members may be called from many threads.
#pragma once

#include "base/array.hpp"
#include "base/grid.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "mesh/user_label.hpp"

#include <functional>
#include <memory>

namespace cleft
{

// The rule for ties: the greater value wins, of equal ones the lower material.
template <class Value>
bool wins(Value value, Material material, Value other_value, Material other)
{
    return value > other_value || (value == other_value && material < other);
}

// The indicators at one point: one entry for each material that has a say there, ascending by material.
// A material without an entry has value 0 in a label map (label indicators are shares, never negative); for indicator
// functions every material has an entry. Reuse one object a thread: the vectors keep their memory.
struct Samples {
    Array<Material> material;
    Array<double> value;
    Array<Vec3> gradient;  // filled by sample_gradient only

    size_t size() const { return material.size(); }
    // The entry of a material, or -1.
    int find(Material m) const
    {
        for (size_t i = 0; i < material.size(); ++i)
            if (material[i] == m)
                return static_cast<int>(i);
        return -1;
    }
    // The entry that wins over all others.
    size_t best() const
    {
        size_t b = 0;
        for (size_t i = 1; i < material.size(); ++i)
            if (wins(value[i], material[i], value[b], material[b]))
                b = i;
        return b;
    }
};

enum class VoxelType { uint8, uint16, int16, uint32, int32 };

// The labels of some voxels in the order in which they come there, and how many voxels have each.
struct LabelCounts {
    Array<UserLabel> labels;
    Array<int64_t> voxels;
};

class Volume
{
public:
    // `kernel` is the width in voxels of the Hann kernel that smooths labels, 2 .. 6 (5 by default).
    static Volume from_labels(VoxelType type, const void* voxels, const Grid& grid, int kernel, const Run& run);
    // K fields of grid.size() values each. K = 1 is a signed function, inside where > 0: material 0 has -f, material 1
    // has +f. `labels` (K values, or 2 for K = 1, or empty for 0 .. K-1) are what the materials are called.
    static Volume from_indicators(const Array<const float*>& fields, const Grid& grid, const Array<UserLabel>& labels,
                                  const Run& run);
    static Volume from_indicators(const Array<const double*>& fields, const Grid& grid, const Array<UserLabel>& labels,
                                  const Run& run);

    // A part of a label map, sampled at the places of the whole. `read`: the planes that `voxels` are; those that may
    // be sampled are fewer (planes_around() in label_planes.hpp). `of_whole` says what the whole map has.
    static Volume from_planes(VoxelType type, const void* voxels, const Grid& whole, Planes read,
                              const LabelCounts& of_whole, int kernel, const Run& run);
    // The same from planes that such a part has stored. `plane(k)` is asked for `sampled` and those that samples see.
    static Volume from_stored_planes(const Grid& whole, Planes sampled, const LabelCounts& of_whole, int kernel,
                                     const std::function<Array<unsigned char>(int32_t k)>& plane);
    Array<unsigned char> stored_plane(int32_t k) const;
    static LabelCounts count_labels(VoxelType type, const void* voxels, int64_t count, const Run& run);
    // Planes of a label map as a volume of their own, in which its materials keep their numbers.
    Volume cropped(Planes planes) const;

    Volume(Volume&&) noexcept;
    Volume& operator=(Volume&&) noexcept;
    ~Volume();

    const Grid& grid() const;
    // What the user calls each material. Materials of a label map are numbered as the voxels first have them.
    const Array<UserLabel>& labels() const;
    // The materials as users see them: ascending by label for a label map, in the order of the functions else.
    Array<Material> listed() const;
    Material material_count() const { return static_cast<Material>(labels().size()); }
    bool is_label_map() const;
    // 0 for a label map, 1 for a signed function.
    int64_t indicator_count() const;
    // The width in voxels of the kernel that smooths labels; 0 for indicator functions.
    int kernel_width() const;

    // The material that holds at the centre of a voxel: its own label in a label map.
    Material voxel_material(int64_t voxel) const;
    // Those of the voxels first .. first + count - 1.
    void voxel_materials(int64_t first, int64_t count, Material* out) const;
    // Number of voxels of each material. Counted when asked for first, by one of the threads that ask.
    const Array<int64_t>& voxel_counts() const;
    LabelCounts label_counts() const;

    // The material of the greatest indicator, as Samples::best() has it.
    Material material_at(const Vec3& x) const;
    // What `out` had is overwritten.
    void sample(const Vec3& x, Samples& out) const;
    // Gradients are with respect to the local frame (world units).
    void sample_gradient(const Vec3& x, Samples& out) const;
    // True if only one material can be met within `reach` of x (conservative: false when not sure). Constant time.
    // Stages skip their work there, so a false costs time but never changes a result.
    bool single_material_near(const Vec3& x, double reach) const;

    struct Data;

private:
    explicit Volume(std::unique_ptr<Data> data);
    std::unique_ptr<Data> data_;
};

}  // namespace cleft
