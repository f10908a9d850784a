// Shape measures of one tetrahedron, the same bits on every machine: no function of the mathematical library is called
// but the square root. The library itself measures whole meshes only.
#pragma once

#include "io/vector3.hpp"

#include <array>

namespace cleft::io
{

using Corners = std::array<Vector3, 4>;

// Positive if the corners are in the order of the library.
double signed_volume(const Corners& corners);

// Cosines of the least and the greatest dihedral angle; 1 and -1 of a flat tetrahedron.
struct AngleCosines {
    double of_least = -1, of_greatest = 1;
};
AngleCosines angle_cosines(const Corners& corners);

// Circumradius over three times the inradius: 1 of the regular tetrahedron, infinite of a flat one.
double radius_ratio(const Corners& corners);

double mean_edge(const Corners& corners);

}  // namespace cleft::io
