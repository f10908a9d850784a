package org.cleft;

/**
 * The shape of a mesh in figures. Angles are dihedral angles, in degrees.
 *
 * @param tetCount tetrahedra
 * @param minDihedral the least angle
 * @param maxDihedral the greatest angle
 * @param tetsBelow5 tetrahedra whose least angle is below 5 degrees
 * @param tetsBelow10 tetrahedra whose least angle is below 10 degrees
 * @param tetsBelow15 tetrahedra whose least angle is below 15 degrees
 * @param tetsBelow20 tetrahedra whose least angle is below 20 degrees
 * @param tetsAbove165 tetrahedra whose greatest angle is above 165 degrees
 * @param radiusRatioMedian circumradius / (3 inradius), 1 for the regular tetrahedron: the median
 * @param radiusRatio95 its 95th percentile
 * @param radiusRatioMax its greatest value
 * @param edgeRatioMax longest / shortest edge of one tetrahedron
 * @param minEdge the shortest edge
 * @param meanEdge the mean edge
 * @param maxEdge the longest edge
 * @param minVolume the least volume of a tetrahedron
 * @param totalVolume the volume of all
 * @param dihedralHistogram all angles, in 36 bins of 5 degrees
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
        java.util.List<Long> dihedralHistogram) {
    static Quality of(NativeQuality q) {
        Long[] bins = new Long[36];
        for (int bin = 0; bin < bins.length; ++bin)
            bins[bin] = q.histogram_bin(bin);
        return new Quality(q.getTet_count(), q.getMin_dihedral(), q.getMax_dihedral(), q.getTets_below_5(),
                q.getTets_below_10(), q.getTets_below_15(), q.getTets_below_20(), q.getTets_above_165(),
                q.getRadius_ratio_median(), q.getRadius_ratio_95(), q.getRadius_ratio_max(), q.getEdge_ratio_max(),
                q.getMin_edge(), q.getMean_edge(), q.getMax_edge(), q.getMin_volume(), q.getTotal_volume(),
                java.util.List.of(bins));
    }
}
