// What the two Gmsh formats share: entities, physical groups and their numbers.
#pragma once

#include "io/atomic_file.hpp"
#include "io/mesh_view.hpp"

#include <vector>

namespace cleft::io
{

constexpr int gmsh_triangle = 2;
constexpr int gmsh_tetrahedron = 4;

// Numbers of the volumes (and of their physical groups), in the order of MeshView::labels. A positive label is its own
// number; others get the least numbers that no label has, as Gmsh's numbers start at 1.
std::vector<int32_t> gmsh_volume_numbers(const MeshView& mesh);

// $PhysicalNames: a name for every volume and every group of triangles.
void write_physical_names(const MeshView& mesh, const std::vector<int32_t>& volumes, AtomicFile& file);

}  // namespace cleft::io
