// A line through the points of a window is the axis; along it, a parabola is fitted to them.
#include "sizing/line_curvature.hpp"

#include "sizing/point_blocks.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace cleft
{

namespace
{

// Voxels of the window to each side. Lines have fewer points than interfaces have, so that a window of 5 would leave
// more of the steps of the voxels.
constexpr int kLineWindow = 6;
// A parabola through fewer points says nothing.
constexpr int kLeastLinePoints = 6;
// Of the window, squared: the points must lie along the axis, or they are of several lines.
constexpr double kLeastLineSpread = 0.02, kMostAcross = 0.3;

bool is_same_line(const TiePoint& a, const TiePoint& b) { return a.of == b.of; }

// Of the points of one line, relative to the middle of the window; 0 where they tell none.
double curvature_of(const Array<Vec3>& points, double window)
{
    if (points.count() < kLeastLinePoints)
        return 0;
    Vec3 mean = Vec3::Zero();
    for (const Vec3& x : points)
        mean += x / static_cast<double>(points.count());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& x : points)
        spread += (x - mean) * (x - mean).transpose() / static_cast<double>(points.count());
    Eigen::SelfAdjointEigenSolver<Mat3> axes;
    axes.computeDirect(spread);
    const double along = axes.eigenvalues()[2];
    if (!(along > kLeastLineSpread * window * window) || axes.eigenvalues()[1] > kMostAcross * along)
        return 0;
    // x(s) = c0 + c1 s + c2 s^2 by least squares: the curvature is the length of 2 c2.
    const Vec3 axis = axes.eigenvectors().col(2);
    Mat3 normal = Mat3::Zero(), right = Mat3::Zero();
    for (const Vec3& x : points) {
        const double s = axis.dot(x - mean);
        const Vec3 powers(1, s, s * s);
        normal += powers * powers.transpose();
        right += powers * (x - mean).transpose();
    }
    const Mat3 coefficients = normal.ldlt().solve(right);
    return coefficients.allFinite() ? 2 * coefficients.row(2).norm() : 0;
}

}  // namespace

Array<CurvedPoint> line_curvatures(const Volume& volume, const Run& run)
{
    const Array<TiePoint> points = find_line_points(volume, run);
    const PointBlocks blocks(volume.grid(), kLineWindow, points, run);
    const auto curvature_at = [&](int64_t block, const TiePoint& middle) {
        Array<Vec3> near;
        blocks.for_each_around(block, [&](int32_t i) {
            const Vec3 from = points[i].x - middle.x;
            if (is_same_line(points[i], middle) && from.cwiseQuotient(blocks.size()).squaredNorm() < 1)
                near.push_back(from);
        });
        return curvature_of(near, blocks.size().minCoeff());
    };
    const auto found = found_by_block<double>(blocks, points, is_same_line, curvature_at, run);
    Array<CurvedPoint> curved;
    curved.reserve(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        curved.push_back({points[i].x, static_cast<float>(found[i])});
    return curved;
}

}  // namespace cleft
