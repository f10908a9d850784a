// The uniform background: a body-centred cubic lattice that ends exactly at the walls of the box.
#pragma once

#include "base/grid.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Fills [0, grid.extent()] with cells as near to cubes as the box allows, mean edge length about `size`. Cells hold a
// point at their centre; two cells that share a face share the four tetrahedra around the line between their centres
// (Labelle and Shewchuk, isosurface stuffing). On a wall, the half of that octahedron inside the box is cut in two.
// Needs no Delaunay engine. Dihedral angles of cubic cells: 60 and 90 degrees inside, 45 and more at the walls.
TetMesh lattice_background(const Grid& grid, double size, const Run& run);

// The same of a part of the box: all tetrahedra whose middle is between two places along the last axis, among others.
TetMesh lattice_slab(const Grid& grid, double size, double low, double high, const Run& run);

// The size that gives about so many tetrahedra, and the other way round.
double lattice_size_for(const Grid& grid, double tets);
double lattice_tets_for(const Grid& grid, double size);

// How many tetrahedra lattice_background() makes: in a flat box more than its size asks for.
double lattice_tets(const Grid& grid, double size);

}  // namespace cleft
