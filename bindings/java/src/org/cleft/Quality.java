// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

import java.util.List;

/**
 * Measures of the shape of a mesh, in world units.
 *
 * @param tetCount number of tetrahedra
 * @param minDihedral the least dihedral angle, in degrees
 * @param maxDihedral the greatest dihedral angle, in degrees
 * @param tetsBelow5 tetrahedra whose least dihedral angle is below 5 degrees
 * @param tetsBelow10 tetrahedra whose least dihedral angle is below 10 degrees
 * @param tetsBelow15 tetrahedra whose least dihedral angle is below 15 degrees
 * @param tetsBelow20 tetrahedra whose least dihedral angle is below 20 degrees
 * @param tetsAbove165 tetrahedra whose greatest dihedral angle is above 165 degrees
 * @param radiusRatioMedian median of the radius ratio, circumradius / (3 * inradius); the least is 1
 * @param radiusRatio95 95th percentile of the radius ratio
 * @param radiusRatioMax the greatest radius ratio
 * @param edgeRatioMax the greatest ratio of longest to shortest edge of one tetrahedron
 * @param minEdge the length of the shortest edge
 * @param meanEdge the mean length of an edge
 * @param maxEdge the length of the longest edge
 * @param minVolume the least volume of a tetrahedron
 * @param totalVolume the volume of all tetrahedra
 * @param dihedralHistogram counts of all dihedral angles, in bins of 5 degrees
 */
public record Quality(
        long tetCount,
        double minDihedral,
        double maxDihedral,
        long tetsBelow5,
        long tetsBelow10,
        long tetsBelow15,
        long tetsBelow20,
        long tetsAbove165,
        double radiusRatioMedian,
        double radiusRatio95,
        double radiusRatioMax,
        double edgeRatioMax,
        double minEdge,
        double meanEdge,
        double maxEdge,
        double minVolume,
        double totalVolume,
        List<Long> dihedralHistogram) {
    static Quality of(NativeQuality row) {
        Long[] dihedralHistogram = new Long[36];
        for (int index = 0; index < 36; ++index)
            dihedralHistogram[index] = row.histogram_bin(index);
        return new Quality(
                row.getTet_count(),
                row.getMin_dihedral(),
                row.getMax_dihedral(),
                row.getTets_below_5(),
                row.getTets_below_10(),
                row.getTets_below_15(),
                row.getTets_below_20(),
                row.getTets_above_165(),
                row.getRadius_ratio_median(),
                row.getRadius_ratio_95(),
                row.getRadius_ratio_max(),
                row.getEdge_ratio_max(),
                row.getMin_edge(),
                row.getMean_edge(),
                row.getMax_edge(),
                row.getMin_volume(),
                row.getTotal_volume(),
                List.of(dihedralHistogram));
    }
}
