// The indicators of a label map at a point.
#pragma once

#include "volume/label_map.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// As the functions of Volume with the same names. The weights of the map must have been found.
template <class Label>
Material voxel_material(const LabelMap<Label>& map, int64_t voxel)
{
    return map.material[voxel - map.first];
}
template <class Label>
void sample(const LabelMap<Label>& map, const Vec3& x, Samples& out);
template <class Label>
void sample_gradient(const LabelMap<Label>& map, const Vec3& x, Samples& out);
template <class Label>
Material material_at(const LabelMap<Label>& map, const Vec3& x);
template <class Label>
bool single_material_near(const LabelMap<Label>& map, const Vec3& x, double reach);

}  // namespace cleft
