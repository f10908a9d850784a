// What a VTK XML file has of an unstructured grid: a whole mesh, or the piece of one process.
#pragma once

#include "io/cell_labels.hpp"

#include <string>
#include <string_view>

namespace cleft::io
{

struct VtuPiece {
    std::vector<double> points;
    CellLists cells;
    std::vector<CellArray> arrays;         // of cells, with one number each
    std::map<int32_t, std::string> names;  // of labels
    std::vector<int64_t> numbers;          // of points in the whole mesh, "GlobalPointIds"; empty: the file has none

    int64_t point_count() const { return static_cast<int64_t>(points.size() / 3); }
};

// The text of a file of one piece. Errors do not name the file. Corners are not checked.
VtuPiece read_vtu_piece(std::string_view text);

}  // namespace cleft::io
