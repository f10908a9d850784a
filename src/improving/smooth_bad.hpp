// Smooths the corners of many bad tetrahedra, on all threads.
#pragma once

#include "improving/constrained_smoother.hpp"
#include "remeshing/worst_first.hpp"

namespace cleft
{

struct CornerSmoothing {
    LocalMesh& mesh;
    const Volume& volume;
    Array<Vec3>& home;  // see ConstrainedSmoother
    double target, tolerance;
};

// Bit i: the corner i of a tetrahedron was moved.
using MovedCorners = uint8_t;

// Tetrahedron after tetrahedron of the list, the corners are moved until it is good enough. The result is that of one
// thread: a visit waits for all earlier ones near it.
Array<MovedCorners> smooth_bad(const CornerSmoothing& smoothing, const WorstFirst& bad, const Run& run);

}  // namespace cleft
