// One function a format. Each writes to a temporary and renames it at its end; all throw Error.
#pragma once

#include "io/mesh_view.hpp"

#include <string>

namespace cleft::io
{

// Order of points and elements is that of the view, and the bytes do not depend on `threads`.
// Formats with triangles need a view with a surface.
void write_vtu(const MeshView& mesh, const std::string& path, int threads);
void write_vtp(const MeshView& mesh, const std::string& path, int threads);
void write_vtk(const MeshView& mesh, const std::string& path);
void write_medit(const MeshView& mesh, const std::string& path);
void write_msh41(const MeshView& mesh, const std::string& path);
void write_msh22(const MeshView& mesh, const std::string& path);
void write_abaqus(const MeshView& mesh, const std::string& path);
void write_tetgen(const MeshView& mesh, const std::string& path);
void write_stl(const MeshView& mesh, const std::string& path);
void write_ply(const MeshView& mesh, const std::string& path);

}  // namespace cleft::io
