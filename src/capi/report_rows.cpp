// Copies field by field: the structs of the stages may change, those of the C interface only grow.
#include "capi/report_rows.hpp"

#include <algorithm>
#include <cstdint>

namespace cleft::capi
{

cleft_quality row_of(const Quality& quality)
{
    cleft_quality row{};
    row.tet_count = quality.tets;
    row.min_dihedral = quality.min_dihedral;
    row.max_dihedral = quality.max_dihedral;
    row.tets_below_5 = quality.below_5;
    row.tets_below_10 = quality.below_10;
    row.tets_below_15 = quality.below_15;
    row.tets_below_20 = quality.below_20;
    row.tets_above_165 = quality.above_165;
    row.radius_ratio_median = quality.radius_ratio_median;
    row.radius_ratio_95 = quality.radius_ratio_95;
    row.radius_ratio_max = quality.radius_ratio_max;
    row.edge_ratio_max = quality.edge_ratio_max;
    row.min_edge = quality.min_edge;
    row.mean_edge = quality.mean_edge;
    row.max_edge = quality.max_edge;
    row.min_volume = quality.min_volume;
    row.total_volume = quality.total_volume;
    std::copy(quality.dihedral_histogram.begin(), quality.dihedral_histogram.end(), row.dihedral_histogram);
    return row;
}

cleft_label_report row_of(const LabelRow& label)
{
    cleft_label_report row{};
    row.label = number_of(label.label);
    row.voxels = label.voxels;
    row.voxel_volume = label.voxel_volume;
    row.mesh_volume = label.mesh_volume;
    row.tets = label.tets;
    row.voxel_components = label.voxel_components;
    row.mesh_components = label.mesh_components;
    row.large_components = label.large_components;
    row.large_components_lost = label.large_components_lost;
    // A function may win at no voxel centre. Its material had nothing to lose.
    row.lost = label.voxels > 0 && label.tets == 0;
    // Programs built before the 64-bit field existed read the number here.
    row.reserved = static_cast<int32_t>(std::min<int64_t>(label.large_components_broken, INT32_MAX));
    row.large_components_broken = label.large_components_broken;
    row.large_components_joined = label.large_components_joined;
    return row;
}

cleft_label_report row_of(const PartLabel& label)
{
    LabelRow all;
    all.label = label.label;
    all.voxels = label.voxels;
    all.voxel_volume = label.voxel_volume;
    all.mesh_volume = label.mesh_volume;
    all.tets = label.tets;
    // Nobody counts pieces across ranks.
    all.voxel_components = all.mesh_components = all.large_components = all.large_components_lost = -1;
    all.large_components_broken = all.large_components_joined = -1;
    cleft_label_report row = row_of(all);
    // What was to be left out is not lost.
    row.lost = row.lost != 0 && label.is_kept;
    return row;
}

}  // namespace cleft::capi
