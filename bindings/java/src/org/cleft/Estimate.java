// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * The expected size of a mesh.
 *
 * @param isRough true if the numbers may be far off, since several interfaces cross one edge: the sizes are large
 * against the parts
 * @param tets tetrahedra of the finished mesh, in the labels that strip and only keep
 * @param wholeTets tetrahedra of the mesh before labels are left out
 * @param backgroundTets tetrahedra of the background
 * @param peakBytes an upper bound on the memory of a process that reads the volume and makes the mesh, in bytes
 */
public record Estimate(
        boolean isRough,
        double tets,
        double wholeTets,
        double backgroundTets,
        double peakBytes) {
    static Estimate of(NativeEstimate row) {
        return new Estimate(
                row.getIs_rough() != 0,
                row.getTets(),
                row.getWhole_tets(),
                row.getBackground_tets(),
                row.getPeak_bytes());
    }
}
