// What is left to do at the points of interfaces: how far the triangles around each of them are from where they belong.
#pragma once

#include "base/array.hpp"
#include "base/counting_sort.hpp"
#include "fitting/interface_triangles.hpp"

namespace cleft
{

// A point of interfaces, and how far it has been moved from its place on the tie.
struct FitPoint {
    int32_t number;
    bool is_fixed = false;
    Vec3 moved{0, 0, 0};
};

// What is left of the heights of the triangles at a point, along their normals.
struct Residual {
    Mat3 normals = Mat3::Zero();  // sum of area n n^T
    Vec3 heights = Vec3::Zero();  // sum of area height n
    double area = 0;
};

// The corners of the triangles, each once, which find their places in it. Those in `without_tie` are fixed, since there
// is no tie from which to move them.
// The numbers of the points are in ascending order, which is the order of all moves that follow.
Array<FitPoint> find_points(const LocalMesh& mesh, const Array<int32_t>& without_tie,
                            Array<InterfaceTriangle>& triangles, const Run& run);

// By point: its triangles, in their order.
using TrianglesAt = Groups<int64_t, int32_t>;
TrianglesAt triangles_at(const Array<InterfaceTriangle>& triangles, const Array<FitPoint>& points, const Run& run);

Array<Residual> find_residuals(const LocalMesh& mesh, const Array<InterfaceTriangle>& triangles, const TrianglesAt& at,
                               const Array<FitPoint>& points, const Run& run);

}  // namespace cleft
