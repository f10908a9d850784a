// A mesh as the readers give it.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace cleft::io
{

struct MeshData {
    std::vector<double> points;            // x y z interleaved
    std::vector<int32_t> tets;             // four corners each, from 0
    std::vector<int32_t> labels;           // one a tetrahedron, or empty if the file has none
    std::map<int32_t, std::string> names;  // of labels, where the file has them
};

// May a number of a file be a label? Whole, of 32 bits, the least one too.
inline bool is_label(double value)
{
    using Range = std::numeric_limits<int32_t>;
    return value == std::floor(value) && value >= Range::min() && value <= Range::max();
}

// One function a format; all throw Error. Numbers of points are checked.
MeshData read_vtu(const std::string& path);
MeshData read_pvtu(const std::string& path);
MeshData read_vtkhdf(const std::string& path);
MeshData read_vtk(const std::string& path);
MeshData read_medit(const std::string& path);
MeshData read_gmsh(const std::string& path);
MeshData read_tetgen(const std::string& path);

}  // namespace cleft::io
