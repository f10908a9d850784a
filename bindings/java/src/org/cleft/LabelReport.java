package org.cleft;

/**
 * What became of one label. Volumes are in world units cubed.
 *
 * @param label the label
 * @param voxels its voxels
 * @param voxelVolume their volume
 * @param meshVolume the volume of its tetrahedra
 * @param tets its tetrahedra
 * @param voxelComponents pieces of its voxels, joined by faces
 * @param meshComponents pieces of its tetrahedra, joined by faces
 * @param largeComponents voxel components of more than 30 voxels
 * @param largeComponentsLost of those, the ones in which no tetrahedron of the label lies
 * @param largeComponentsBroken of those, the ones that lie in several components of the mesh
 * @param largeComponentsJoined of those, the ones that lie in one component of the mesh with another
 * @param lost whether the label has voxels but no tetrahedron
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
        long largeComponentsBroken,
        long largeComponentsJoined,
        boolean lost) {
    static LabelReport of(NativeLabelReport row) {
        return new LabelReport(row.getLabel(), row.getVoxels(), row.getVoxel_volume(), row.getMesh_volume(),
                row.getTets(), row.getVoxel_components(), row.getMesh_components(), row.getLarge_components(),
                row.getLarge_components_lost(), row.getLarge_components_broken(), row.getLarge_components_joined(),
                row.getLost() != 0);
    }
}
