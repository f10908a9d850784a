// The arrays of a legacy VTK file behind its geometry, found without reading more than one of them.
#pragma once

#include "io/image.hpp"
#include "io/text_source.hpp"

#include <string>
#include <vector>

namespace cleft::io
{

// What stands in front of the values of an array, and where they begin.
struct VtkArray {
    std::string name;
    bool on_cells = false;
    int64_t tuples = 0;
    int64_t components = 1;
    bool is_bit = false;
    bool is_colour = false;  // bytes in binary files, fractions of 255 in text
    bool is_numeric = true;
    bool is_id = false;  // numbers the points or cells
    Component component = Component::uint8;
    uintmax_t place = 0;  // of its values in the file
};

// The arrays of points and cells, of which there must be so many. `source` stands at POINT_DATA, at CELL_DATA or at the
// end.
// Throws Errors that do not name the file.
std::vector<VtkArray> find_vtk_arrays(TextSource& source, bool binary, int64_t points, int64_t cells);

// What numbers of this type are; "vtkIdType" and so on are the names in the file.
// Throws Error(CLEFT_ERROR_FORMAT) for bits and texts.
Component vtk_number_type(const std::string& type);
// Passes over a block METADATA, which VTK writes behind an array of so many components, if there is one.
void skip_vtk_metadata(TextSource& source, int64_t components);
// FIELD name n, of which the first word was taken: passes over arrays that belong to neither points nor cells.
void skip_vtk_field(TextSource& source, bool binary);

// A count that stands in the file. `what` is for Errors.
int64_t vtk_count(TextSource& source, const char* what);

}  // namespace cleft::io
