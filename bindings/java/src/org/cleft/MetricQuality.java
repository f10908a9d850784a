// Made by tools/generate.py from include/cleft/cleft.h.
package org.cleft;

import java.util.List;

/**
 * How well a mesh meets a metric, which measures an edge of the wanted length as 1.
 *
 * @param tetCount number of tetrahedra
 * @param edgeCount number of edges
 * @param edgesInRange edges whose length in the metric is within 1/sqrt(2) to sqrt(2)
 * @param edgeLeast the least length of an edge in the metric
 * @param edge01 1st percentile of the lengths
 * @param edgeMedian median of the lengths
 * @param edge99 99th percentile of the lengths
 * @param edgeGreatest the greatest length
 * @param meanRatioLeast the least mean ratio: 1 is regular in the metric, 0 flat
 * @param meanRatio01 1st percentile of the mean ratio
 * @param meanRatioMedian median of the mean ratio
 * @param minDihedral the least dihedral angle in the metric, in degrees
 * @param maxDihedral the greatest dihedral angle in the metric, in degrees
 * @param dihedralHistogram counts of all dihedral angles in the metric, in bins of 5 degrees
 */
public record MetricQuality(
        long tetCount,
        long edgeCount,
        long edgesInRange,
        double edgeLeast,
        double edge01,
        double edgeMedian,
        double edge99,
        double edgeGreatest,
        double meanRatioLeast,
        double meanRatio01,
        double meanRatioMedian,
        double minDihedral,
        double maxDihedral,
        List<Long> dihedralHistogram) {
    static MetricQuality of(NativeMetricQuality row) {
        Long[] dihedralHistogram = new Long[36];
        for (int index = 0; index < 36; ++index)
            dihedralHistogram[index] = row.histogram_bin(index);
        return new MetricQuality(
                row.getTet_count(),
                row.getEdge_count(),
                row.getEdges_in_range(),
                row.getEdge_least(),
                row.getEdge_01(),
                row.getEdge_median(),
                row.getEdge_99(),
                row.getEdge_greatest(),
                row.getMean_ratio_least(),
                row.getMean_ratio_01(),
                row.getMean_ratio_median(),
                row.getMin_dihedral(),
                row.getMax_dihedral(),
                List.of(dihedralHistogram));
    }
}
