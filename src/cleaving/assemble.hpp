// From centres to the output mesh.
#pragma once

#include "cleaving/centres.hpp"

namespace cleft
{

// Gives up cuts of tetrahedra that would otherwise split into pieces of no volume (slivers of the background), the
// least central cut first, until none is left that a smaller number of cuts can mend. Returns the number given up.
int64_t give_up_flat_cuts(Centres& c, const Run& run);

// Numbers the points in use (vertices, cuts, triple points, quadruple points) and writes the fans with their materials.
// Notes cleaving.cuts, .triples, .quads and .steiner.
LabelledMesh assemble(const Centres& c, const Run& run);

// The points of that mesh at which interfaces may be pinched, ascending: those of vertices in doubt, and at cuts that
// were given up. Of a pinched edge one end is among them.
std::vector<int32_t> points_in_doubt(const Centres& c);

}  // namespace cleft
