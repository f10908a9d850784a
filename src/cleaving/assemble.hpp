// From centres to the output mesh.
#pragma once

#include "base/array.hpp"
#include "cleaving/centres.hpp"

namespace cleft
{

// Numbers the points in use (vertices, cuts, triple points, quadruple points) and writes the fans with their materials.
// Notes cleaving.cuts, .triples, .quads and .steiner.
LabelledMesh assemble(const Centres& c, const Run& run);

// The points of that mesh at which interfaces may be pinched, ascending: those of vertices in doubt, and at cuts that
// were given up. Of a pinched edge one end is among them.
Array<int32_t> points_in_doubt(const Centres& c, const Run& run);

}  // namespace cleft
