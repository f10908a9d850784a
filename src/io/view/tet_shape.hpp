// The shape of one tetrahedron, as the page tells it of the worst ones.
#pragma once

#include "io/vector3.hpp"

namespace cleft::io
{

struct TetShape {
    double least_angle = 0;     // dihedral, in degrees
    double greatest_angle = 0;  // likewise
    double radius_ratio = 0;    // circumradius / (3 * inradius), 1 for a regular one; infinite for a flat one
    double volume = 0;          // negative for the other orientation
};

TetShape shape_of(const Vector3 (&corners)[4]);

}  // namespace cleft::io
