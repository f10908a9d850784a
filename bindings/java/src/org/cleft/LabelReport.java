// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * What became of one label. Volumes are in cubic world units.
 *
 * @param label the label
 * @param voxels number of its voxels
 * @param voxelVolume the volume of its voxels
 * @param meshVolume the volume of its tetrahedra
 * @param tets number of its tetrahedra
 * @param voxelComponents components of its voxels
 * @param meshComponents components of its tetrahedra
 * @param largeComponents voxel components of more than 30 voxels
 * @param largeComponentsLost large components in which no tetrahedron of the label lies
 * @param lost true if the label has voxels but no tetrahedron
 * @param largeComponentsBroken large components that lie in several components of the mesh, each with half a voxel or
 * more. Such a part broke because it is thinner than the tetrahedra around it; a smaller size there keeps it whole
 * @param largeComponentsJoined large components that share a component of the mesh with another large one, each with
 * half a voxel or more. They touch over an edge or corner of voxels, or are nearer than one element
 */
public record LabelReport(
        int label,
        long voxels,
        double voxelVolume,
        double meshVolume,
        long tets,
        long voxelComponents,
        long meshComponents,
        long largeComponents,
        long largeComponentsLost,
        boolean lost,
        long largeComponentsBroken,
        long largeComponentsJoined) {
    static LabelReport of(NativeLabelReport row) {
        return new LabelReport(
                row.getLabel(),
                row.getVoxels(),
                row.getVoxel_volume(),
                row.getMesh_volume(),
                row.getTets(),
                row.getVoxel_components(),
                row.getMesh_components(),
                row.getLarge_components(),
                row.getLarge_components_lost(),
                row.getLost() != 0,
                row.getLarge_components_broken(),
                row.getLarge_components_joined());
    }
}
