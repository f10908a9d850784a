// Symmetric 3 x 3 tensors: metrics, their logarithms and their square roots.
#pragma once

#include "base/vec.hpp"

namespace cleft
{

// The upper triangle by rows.
struct Tensor {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    double trace() const { return xx + yy + zz; }
    Mat3 matrix() const;
};

inline Tensor operator+(const Tensor& a, const Tensor& b)
{
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}
inline Tensor operator*(double s, const Tensor& a)
{
    return {s * a.xx, s * a.xy, s * a.xz, s * a.yy, s * a.yz, s * a.zz};
}
// Of commuting tensors alone: then the product is symmetric.
inline Tensor product(const Tensor& a, const Tensor& b)
{
    return {a.xx * b.xx + a.xy * b.xy + a.xz * b.xz, a.xx * b.xy + a.xy * b.yy + a.xz * b.yz,
            a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
            a.xy * b.xz + a.yy * b.yz + a.yz * b.zz, a.xz * b.xz + a.yz * b.yz + a.zz * b.zz};
}
inline Vec3 operator*(const Tensor& a, const Vec3& v)
{
    return {a.xx * v[0] + a.xy * v[1] + a.xz * v[2], a.xy * v[0] + a.yy * v[1] + a.yz * v[2],
            a.xz * v[0] + a.yz * v[1] + a.zz * v[2]};
}
// v^T a v.
inline double square(const Tensor& a, const Vec3& v)
{
    return a.xx * v[0] * v[0] + a.yy * v[1] * v[1] + a.zz * v[2] * v[2] +
           2 * (a.xy * v[0] * v[1] + a.xz * v[0] * v[2] + a.yz * v[1] * v[2]);
}

inline Tensor to_tensor(const Mat3& m) { return {m(0, 0), m(0, 1), m(0, 2), m(1, 1), m(1, 2), m(2, 2)}; }

// The exponential of the part without trace, which has the determinant 1.
Tensor unit_exp(const Tensor& log);
Tensor exp(const Tensor& log);
// Of a positive definite tensor.
Tensor log(const Tensor& metric);
// The least metric that is nowhere less than either: its lengths are no greater than theirs in any direction, and their
// unit balls touch its own (simultaneous reduction; Alauzet 2010). The first must be positive definite.
Tensor intersection(const Tensor& a, const Tensor& b);
// a is greater than b in every direction. At equality, either answer.
bool covers(const Tensor& a, const Tensor& b);
// From the least to the greatest.
Vec3 eigenvalues(const Tensor& tensor);

}  // namespace cleft
