// The graded background: body-centred cubic cells whose size follows the sizing field by a balanced octree.
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "sizing/sizing_field.hpp"

namespace cleft
{

// Fills the box exactly, whatever its shape: the roots of the octree are a grid of nearly cubic cells. Needs no
// Delaunay engine. Cells that share a face or an edge differ by one level at most, which leaves three kinds of places
// only (after Labelle and Shewchuk, isosurface stuffing): see octree.cpp.
TetMesh octree_background(const SizingField& field, const Run& run);

// The same of a part of the box: all tetrahedra whose middle is between two places along the last axis, among others.
// `field` has the planes that octree_slab_planes() says, and `sizes` are those of the whole field.
TetMesh octree_slab(const SizingField& field, const SizeRange& sizes, double low, double high, const Run& run);
Planes octree_slab_planes(const Grid& grid, const SizeRange& sizes, double low, double high);

// How many tetrahedra that has, by its tree alone; those that split sides add are taken as usual.
int64_t octree_tets(const SizingField& field, const Run& run);

// The same where the number is near `limit`; farther away a rough number, by which it is known on which side it is.
double octree_tets_near_limit(const SizingField& field, double limit, const Run& run);

}  // namespace cleft
