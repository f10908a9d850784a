// Exponentials by scaling and squaring: no eigenvectors, whose choice jumps where eigenvalues meet.
#include "metric/tensor.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace cleft
{

Mat3 Tensor::matrix() const
{
    Mat3 m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
}

Tensor unit_exp(const Tensor& log)
{
    const double mean = log.trace() / 3;
    Tensor a{log.xx - mean, log.xy, log.xz, log.yy - mean, log.yz, log.zz - mean};
    // A bound on its eigenvalues.
    double norm = std::sqrt(a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz));
    int halvings = 0;
    // Below a quarter, the next term of the series is less than 1e-8.
    for (; norm > 0.25; norm *= 0.5)
        ++halvings;
    a = std::ldexp(1.0, -halvings) * a;
    const auto plus_one = [](Tensor t) {
        t.xx += 1;
        t.yy += 1;
        t.zz += 1;
        return t;
    };
    Tensor sum = plus_one(1.0 / 6 * a);
    for (const double factor : {1.0 / 5, 1.0 / 4, 1.0 / 3, 1.0 / 2, 1.0})
        sum = plus_one(factor * product(a, sum));
    for (int i = 0; i < halvings; ++i)
        sum = product(sum, sum);
    return sum;
}

Tensor exp(const Tensor& log) { return std::exp(log.trace() / 3) * unit_exp(log); }

Tensor log(const Tensor& metric)
{
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(metric.matrix());
    const Vec3 logs = solver.eigenvalues().array().log();
    return to_tensor(solver.eigenvectors() * logs.asDiagonal() * solver.eigenvectors().transpose());
}

Tensor intersection(const Tensor& a, const Tensor& b)
{
    // In the frame in which a is the identity, the eigenvectors of b are common axes.
    const Eigen::LLT<Mat3> root(a.matrix());
    const Mat3 lower = root.matrixL();
    Mat3 there = root.matrixL().solve(b.matrix());
    there = root.matrixL().solve(there.transpose().eval()).eval();
    Eigen::SelfAdjointEigenSolver<Mat3> axes;
    axes.computeDirect(0.5 * (there + there.transpose()));
    const Mat3 back = lower * axes.eigenvectors();
    return to_tensor(back * axes.eigenvalues().cwiseMax(1).asDiagonal() * back.transpose());
}

bool covers(const Tensor& a, const Tensor& b)
{
    // The difference is positive definite: its leading minors are positive (Sylvester).
    const Tensor d = a + -1.0 * b;
    const double second = d.xx * d.yy - d.xy * d.xy;
    return d.xx > 0 && second > 0 &&
           d.zz * second - d.xx * d.yz * d.yz + 2 * d.xy * d.xz * d.yz - d.yy * d.xz * d.xz > 0;
}

// By the angle of the cubic's roots (Smith 1961). An error of its rounding is far below what a size needs.
Vec3 eigenvalues(const Tensor& a)
{
    const double mean = a.trace() / 3;
    const double x = a.xx - mean, y = a.yy - mean, z = a.zz - mean;
    const double off = a.xy * a.xy + a.xz * a.xz + a.yz * a.yz;
    const double p = std::sqrt((x * x + y * y + z * z + 2 * off) / 6);
    if (!(p > 0))
        return {mean, mean, mean};
    const double determinant =
        x * (y * z - a.yz * a.yz) - a.xy * (a.xy * z - a.yz * a.xz) + a.xz * (a.xy * a.yz - y * a.xz);
    const double angle = std::acos(std::clamp(0.5 * determinant / (p * p * p), -1.0, 1.0)) / 3;
    constexpr double kThird = 2.0943951023931953;  // of a circle
    const double greatest = mean + 2 * p * std::cos(angle), least = mean + 2 * p * std::cos(angle + kThird);
    return {least, 3 * mean - least - greatest, greatest};
}

}  // namespace cleft
