// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

/**
 * What a mesh will come to.
 *
 * @param isBound true if there may be fewer: labels have few points each, and most cuts may have to stay
 * @param tets tetrahedra of the finished mesh, in the labels that strip and only keep
 * @param wholeTets tetrahedra of the mesh from which the other labels are left out
 * @param backgroundTets tetrahedra of the background that is cleaved
 * @param peakBytes the most memory that a process takes to make the mesh, in bytes, no less
 */
public record Estimate(
        boolean isBound,
        double tets,
        double wholeTets,
        double backgroundTets,
        double peakBytes) {
    static Estimate of(NativeEstimate row) {
        return new Estimate(
                row.getIs_bound() != 0,
                row.getTets(),
                row.getWhole_tets(),
                row.getBackground_tets(),
                row.getPeak_bytes());
    }
}
