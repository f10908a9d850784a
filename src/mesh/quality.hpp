// Shape measures of tetrahedra and their summary.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Six times the signed volume.
inline double orient(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return (b - a).cross(c - a).dot(d - a);
}

// Least sine of the six dihedral angles (bounds the largest angle too); negative if inverted, 0 if flat.
// Unlike angle_quality() it does not favour either end.
double least_sine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// Least sine of the six dihedral angles, that of an obtuse angle times kObtuseWeight. 155 degrees are as bad as 20. A
// little below, so that a quality of sin(20) or more also keeps all angles below 155 degrees, in spite of rounding.
inline constexpr double kObtuseWeight = 0.8092;  // sin(20) / sin(25)
// The obtuse angle that is as bad as an acute one, both in degrees; 90 where none is.
double greatest_angle(double least_angle);
double angle_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// The measure that local operations raise: angle_quality(), and kRatioWeight / radius_ratio() where that is less. A
// ratio of 8 is as bad as 25 degrees. Needles can have good angles: without this, ratios were up to 22.
inline constexpr double kRatioWeight = 3.3809;  // 8 sin(25), rounded down as above
// The radius ratio that is as bad as an acute angle in degrees.
double greatest_ratio(double least_angle);
double shape_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// The six dihedral angles in degrees, in the order of kEdgeCorners.
FixedArray<double, 6> dihedral_angles(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

// Circumradius / (3 inradius): 1 for the regular tetrahedron, larger is worse.
double radius_ratio(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

struct Quality {
    int64_t tets = 0;
    // Degrees, over all angles.
    double min_dihedral = 0, max_dihedral = 0;
    // Tetrahedra by their least angle, and by their greatest.
    int64_t below_5 = 0, below_10 = 0, below_15 = 0, below_20 = 0;
    int64_t above_165 = 0;
    // Of the tetrahedra that are not exactly flat; percentiles interpolate between ranks.
    double radius_ratio_median = 0, radius_ratio_95 = 0, radius_ratio_max = 0;
    // Longest / shortest edge of one tetrahedron.
    double edge_ratio_max = 0;
    // Of the edges of tetrahedra, each counted once a tetrahedron.
    double min_edge = 0, mean_edge = 0, max_edge = 0;
    // Signed.
    double min_volume = 0, total_volume = 0;
    // All angles, bins of 5 degrees.
    FixedArray<int64_t, 36> dihedral_histogram{};
};

// All zero for no tetrahedra. Corners must be points of the mesh.
Quality measure_quality(const Array<Vec3>& points, const Array<Tet>& tets, const Run& run);

}  // namespace cleft
