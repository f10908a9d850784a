// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * What became of one label. Volumes are in world units cubed.
 *
 * @param label the label
 * @param voxels its voxels
 * @param voxelVolume the volume of its voxels
 * @param meshVolume the volume of its tetrahedra
 * @param tets its tetrahedra
 * @param voxelComponents pieces of its voxels, joined by faces
 * @param meshComponents pieces of its tetrahedra, joined by faces
 * @param largeComponents voxel components of more than 30 voxels
 * @param largeComponentsLost of those, the ones in which no tetrahedron of the label lies
 * @param lost true if the label has voxels but no tetrahedron
 * @param largeComponentsBroken of the large components, those that lie in several components of the mesh, each with
 * half a voxel or more: parts thinner than the tetrahedra around broke; a smaller size there keeps them
 * @param largeComponentsJoined of the large components, those that lie in one component of the mesh with another of
 * them, each with half a voxel or more. They touch over an edge or a corner of voxels, or are nearer than an element
 * tells apart
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
