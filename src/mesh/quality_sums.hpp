// What is measured of some tetrahedra of a mesh, so that it can be combined with what is measured of the others.
#pragma once

#include "mesh/quality.hpp"

namespace cleft
{

// The Quality has in it the sum of all edges as mean_edge, and no percentiles.
struct QualitySums {
    Quality q;
    // Of the extreme angles, which are found by their cosines.
    double greatest_cosine = -2, least_cosine = 2;

    QualitySums();
};

struct MeasuredTets {
    QualitySums sums;
    Array<double> ratios;  // the radius ratios that are finite
};

// Of the first `count` tetrahedra. Corners must be among the points.
MeasuredTets measure_tets(const Array<Vec3>& points, const Array<Tet>& tets, int64_t count, const Run& run);

// Adds what was measured of the tetrahedra that follow: of equal extremes the first counts.
void combine(const QualitySums& from, QualitySums& to);

// The percentiles of the radius ratio that a Quality has: the median and that of 95 %.
inline constexpr double kRatioShares[] = {0.5, 0.95};
// `ratio_percentiles` by kRatioShares; 0 if no ratio is finite. All is zero for no tetrahedra.
Quality finished(const QualitySums& sums, const Array<double>& ratio_percentiles);

}  // namespace cleft
