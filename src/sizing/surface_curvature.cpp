// Normals are fitted in windows, one for each side of an interface in a block of voxels.
#include "sizing/surface_curvature.hpp"

#include "base/touched_array.hpp"
#include "sizing/point_blocks.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Voxels of the window to each side, and of a block: the blocks around one have all of its windows.
// With 5, planes read as curved with a radius of 150 voxels or more, and a ball of radius 34 from labels within 15 %.
constexpr int kWindow = 5;
// Normals further apart are of another side of a thin part.
constexpr double kLeastCosine = 0.5;
// Points that a thread takes. The number changes the time alone.
constexpr int64_t kPointsAtOnce = 4096;
// A plane fitted to fewer points says nothing.
constexpr int kLeastPoints = 8;
// Of the window, squared: points that lie along a line tell the curvature along it alone.
constexpr double kLeastSpread = 0.01;

struct SurfacePoint {
    TieMaterials of;
    Vec3 x, normal;  // towards the first material
};

Array<SurfacePoint> with_normals(const Volume& volume, const Array<TiePoint>& points, const Run& run)
{
    Array<SurfacePoint> out = large_array<SurfacePoint>(run, points.size());
    parallel_for(run, points.count(), kPointsAtOnce, [&](int64_t begin, int64_t end) {
        Samples samples;
        for (int64_t i = begin; i < end; ++i) {
            const TiePoint& p = points[i];
            volume.sample_gradient(p.x, samples);
            const auto gradient = [&](Material m) {
                const int at = samples.find(m);
                return at < 0 ? Vec3(0, 0, 0) : samples.gradient[at];
            };
            out[i] = {p.of, p.x, (gradient(p.of.material[0]) - gradient(p.of.material[1])).normalized()};
        }
    });
    return out;
}

bool is_same_side(const SurfacePoint& a, const SurfacePoint& b)
{
    return a.of == b.of && a.normal.dot(b.normal) > kLeastCosine;
}

// Weighted sums over the points of a window.
struct Sums {
    int count = 0;
    double weight = 0;
    Vec3 x = Vec3::Zero(), normal = Vec3::Zero();
    Mat3 x_x = Mat3::Zero(), normal_x = Mat3::Zero();

    void add(double w, const Vec3& at, const Vec3& n)
    {
        ++count;
        weight += w;
        x += w * at;
        normal += w * n;
        x_x += w * at * at.transpose();
        normal_x += w * n * at.transpose();
    }
};

// The two directions are those of the window, with what the curvature along each is.
Bend bend_of(const Sums& s, double window)
{
    Bend bend{Vec3::Zero(), Vec3::Zero(), {Vec3::Zero(), Vec3::Zero()}, {-1, -1}};
    if (s.count < kLeastPoints)
        return bend;
    const Vec3 x = s.x / s.weight, n = s.normal.normalized();
    const Mat3 spread = s.x_x / s.weight - x * x.transpose();
    const Mat3 slope = s.normal_x / s.weight - s.normal / s.weight * x.transpose();
    Eigen::Matrix<double, 3, 2> tangent;
    tangent.col(0) = n.unitOrthogonal();
    tangent.col(1) = n.cross(tangent.col(0));
    const Eigen::Matrix2d places = tangent.transpose() * spread * tangent,
                          normals = tangent.transpose() * slope * tangent;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(places);
    const double least = kLeastSpread * window * window;
    if (!(axes.eigenvalues()[1] > least))
        return bend;
    if (!(axes.eigenvalues()[0] > least)) {
        const Eigen::Vector2d along = axes.eigenvectors().col(1);
        bend.along = {Vec3(tangent * axes.eigenvectors().col(0)), Vec3(tangent * along)};
        bend.curvature[1] = std::abs(along.dot(normals * along)) / axes.eigenvalues()[1];
        return bend;
    }
    const Eigen::Matrix2d curvature = normals * places.inverse();
    const Eigen::Matrix2d symmetric = 0.5 * (curvature + curvature.transpose());
    axes.computeDirect(symmetric);
    for (int i = 0; i < 2; ++i) {
        bend.along[static_cast<size_t>(i)] = tangent * axes.eigenvectors().col(i);
        bend.curvature[static_cast<size_t>(i)] = std::abs(axes.eigenvalues()[i]);
    }
    return bend;
}

Bend bend_at(const PointBlocks& blocks, int64_t block, const Array<SurfacePoint>& points, const SurfacePoint& middle)
{
    Sums sums;
    blocks.for_each_around(block, [&](int32_t i) {
        const SurfacePoint& p = points[i];
        const Vec3 from = p.x - middle.x;
        const double square = from.cwiseQuotient(blocks.size()).squaredNorm();
        if (square < 1 && is_same_side(p, middle))
            sums.add((1 - square) * (1 - square), from, p.normal);
    });
    return bend_of(sums, blocks.size().minCoeff());
}

}  // namespace

Array<Bend> surface_bends(const Volume& volume, const Run& run)
{
    const Array<SurfacePoint> points = with_normals(volume, find_interface_points(volume, run), run);
    const PointBlocks blocks(volume.grid(), kWindow, points, run);
    Array<Bend> bends = found_by_block<Bend>(
        blocks, points, is_same_side,
        [&](int64_t block, const SurfacePoint& middle) { return bend_at(blocks, block, points, middle); }, run);
    parallel_for(run, bends.count(), kPointsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            bends[i].x = points[i].x;
            bends[i].normal = points[i].normal;
        }
    });
    return bends;
}

Array<CurvedPoint> surface_curvatures(const Volume& volume, const Run& run)
{
    const Array<Bend> bends = surface_bends(volume, run);
    Array<CurvedPoint> points = large_array<CurvedPoint>(run, bends.size());
    parallel_for(run, bends.count(), kPointsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const Bend& bend = bends[i];
            points[i] = {bend.x, static_cast<float>(std::max({0.0, bend.curvature[0], bend.curvature[1]}))};
        }
    });
    return points;
}

}  // namespace cleft
