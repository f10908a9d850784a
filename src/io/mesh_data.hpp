// A mesh as the readers give it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

struct MeshData {
    std::vector<double> points;   // x y z interleaved
    std::vector<int32_t> tets;    // four corners each, from 0
    std::vector<int32_t> labels;  // one a tetrahedron, or empty if the file has none
};

// One function a format; all throw Error. Numbers of points are checked.
MeshData read_vtu(const std::string& path);
MeshData read_vtk(const std::string& path);
MeshData read_medit(const std::string& path);
MeshData read_gmsh(const std::string& path);
MeshData read_tetgen(const std::string& path);

}  // namespace cleft::io
