// What the shape of a tetrahedron is measured by where it gives the colour.
#pragma once

#include "cleft/cleft_io.h"
#include "io/tet_shape.hpp"

namespace cleft::io
{

// Of CLEFT_IO_BY_ANGLE the least dihedral angle in degrees, within 1/1000; 0 of a flat tetrahedron. Of
// CLEFT_IO_BY_RATIO the radius ratio, 1 of the regular tetrahedron and infinite of a flat one. Of CLEFT_IO_BY_SIZE the
// mean edge. The same bits on every machine: no function of the mathematical library is called but the square root.
double tet_measure(cleft_io_colouring by, const Corners& corners);

// The logarithm to the base 2 of a number above 0, likewise the same everywhere.
double same_log2(double value);

}  // namespace cleft::io
