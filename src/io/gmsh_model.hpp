// What the two Gmsh formats share: the types of elements, and the names of physical groups.
#pragma once

#include "io/atomic_file.hpp"
#include "io/mesh_view.hpp"

namespace cleft::io
{

// Element types of the MSH formats ("MSH file format" in Gmsh's manual), the same in 2.2 and 4.1.
constexpr int kGmshTriangle = 2;
constexpr int kGmshTetrahedron = 4;

// $PhysicalNames: a name for every volume and every group of triangles.
void write_physical_names(const MeshView& mesh, AtomicFile& file);

}  // namespace cleft::io
