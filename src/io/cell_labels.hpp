// Cells and cell arrays of VTK's formats, and the tetrahedra and materials in them.
#pragma once

#include "io/mesh_data.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

// The lists as the file has them, not yet checked against each other or against the number of
// points.
struct CellLists {
    std::vector<int64_t> corners;
    std::vector<int64_t> offsets;  // one more than there are cells: cell i has corners [offsets[i], offsets[i + 1])
    std::vector<int32_t> types;
};

struct CellArray {
    std::string name;
    int64_t components = 1;
    std::vector<double> values;
};

// Throws an Error where a coordinate is not finite. Readers of text check each number as they scan it; arrays of bytes
// may hold NaN.
void check_finite(const std::vector<double>& points);

// Puts the tetrahedra and their labels into `mesh`, whose points are there. The labels are the array "material", else
// the first array with one whole number a cell. Errors do not name the file.
void take_tetrahedra(const CellLists& cells, const std::vector<CellArray>& arrays, MeshData& mesh);

}  // namespace cleft::io
