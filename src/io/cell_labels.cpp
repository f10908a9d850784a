// The tetrahedra and labels of a VTK file, whatever its form.
#include "io/cell_labels.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

constexpr int32_t kVtkTetra = 10;  // VTK_TETRA of the list of cell types in "VTK File Formats"

[[noreturn]] void fail(const std::string& what) { throw Error(CLEFT_ERROR_FORMAT, what); }

bool holds_labels(const CellArray& array, size_t cells)
{
    // Colours and vectors on cells are common in files of ParaView. They are not labels, even if
    // all their numbers are whole.
    if (array.components != 1 || array.values.size() != cells)
        return false;
    for (const double value : array.values)
        if (!is_label(value))
            return false;
    return true;
}

const CellArray* find_labels(const std::vector<CellArray>& arrays, size_t cells)
{
    // The writers of Cleft call the array "material". A file with an unusable array of that name is
    // an error, as taking another array would mislabel the mesh.
    for (const CellArray& array : arrays)
        if (array.name == "material") {
            if (!holds_labels(array, cells))
                fail("the array 'material' must hold one whole number of 32 bits a cell");
            return &array;
        }
    // Other programs have names of their own, so the first array of whole numbers is taken, as the
    // documentation says.
    for (const CellArray& array : arrays)
        if (holds_labels(array, cells))
            return &array;
    return nullptr;
}

// Vertices, lines and plane cells, of first and second order.
bool is_lower_dimensional(int32_t type)
{
    // 0 is an empty cell; 1 to 9 are points, lines and polygons. 21 to 23 are the quadratic edge,
    // triangle and quadrilateral; 28 and 34 are the biquadratic quadrilateral and triangle. Gmsh
    // and meshio write them beside the tetrahedra of a volume.
    return (type >= 0 && type <= 9) || (type >= 21 && type <= 23) || type == 28 || type == 34;
}

}  // namespace

void check_finite(const std::vector<double>& points)
{
    if (!std::all_of(points.begin(), points.end(), [](double coordinate) { return std::isfinite(coordinate); }))
        fail("a coordinate is not finite");
}

void take_tetrahedra(const CellLists& cells, const std::vector<CellArray>& arrays, MeshData& mesh)
{
    const size_t count = cells.types.size();
    // Offsets begin with a 0 that is not in the file, so there is one more than cells. A file
    // without cells may have none.
    if (cells.offsets.size() != count + 1 && !(count == 0 && cells.offsets.empty()))
        fail("there are " + std::to_string(count) + " types of cells, but another number of cells");
    const CellArray* labels = find_labels(arrays, count);
    const int64_t points = static_cast<int64_t>(mesh.points.size() / 3);
    for (size_t c = 0; c < count; ++c) {
        if (is_lower_dimensional(cells.types[c]))
            continue;
        if (cells.types[c] != kVtkTetra)
            throw Error(CLEFT_ERROR_UNSUPPORTED, "the " + ordinal(static_cast<int64_t>(c)) +
                                                     " cell is no tetrahedron but of VTK's type " +
                                                     std::to_string(cells.types[c]));
        const int64_t begin = cells.offsets[c];
        const int64_t end = cells.offsets[c + 1];
        // Offsets come from the file and may go back or beyond the list of corners. Written as end
        // - 4, so that no sum can overflow.
        if (begin < 0 || end - 4 != begin || end > static_cast<int64_t>(cells.corners.size()))
            fail("the " + ordinal(static_cast<int64_t>(c)) + " cell does not have four corners");
        for (int64_t i = begin; i < end; ++i) {
            const int64_t point = cells.corners[static_cast<size_t>(i)];
            if (point < 0 || point >= points)
                fail("the " + ordinal(static_cast<int64_t>(c)) + " cell names point " + std::to_string(point) +
                     " of the " + std::to_string(points) + " that are counted from 0");
            mesh.tets.push_back(static_cast<int32_t>(point));
        }
        if (labels)
            mesh.labels.push_back(static_cast<int32_t>(labels->values[c]));
    }
}

}  // namespace cleft::io
