// VTK legacy, text: versions up to 4.2 and 5 (in which cells are offsets and corners). Keywords do not depend on case
// ("VTK File Formats").
#include "base/counted.hpp"
#include "io/ascii.hpp"
#include "io/cell_labels.hpp"
#include "io/mesh_data.hpp"
#include "io/text_scanner.hpp"

namespace cleft::io
{

namespace
{

// METADATA run to the next empty line. Newer versions of VTK write them behind arrays: names of components, and no
// closing keyword.
void skip_metadata(TextScanner& in, int64_t components)
{
    if (in_capitals(in.peek()) != "METADATA")
        return;
    in.word();
    in.skip_line();
    for (std::string_view line = in.rest_of_line(); !line.empty(); line = in.rest_of_line())
        if (in_capitals(line) == "COMPONENT_NAMES")
            // A component without a name has an empty line, which does not end the block.
            for (int64_t i = 0; i < components; ++i)
                in.skip_line();
}

std::vector<int64_t> read_integers(TextScanner& in, int64_t count)
{
    // A digit and a blank for each number.
    in.check_count(count, 2, "numbers");
    std::vector<int64_t> numbers(static_cast<size_t>(count));
    for (int64_t& number : numbers)
        number = in.integer();
    skip_metadata(in, 1);
    return numbers;
}

std::vector<double> read_reals(TextScanner& in, int64_t tuples, int64_t components)
{
    const int64_t count = tuples * components;
    in.check_count(count, 2, "numbers");
    std::vector<double> numbers(static_cast<size_t>(count));
    for (double& number : numbers)
        number = in.real();
    skip_metadata(in, components);
    return numbers;
}

// The corners of all cells in a row, and where each cell begins.
CellLists read_cells(TextScanner& in)
{
    const int64_t first = in.count(1, "cells");
    // Version 3: the number of all numbers that follow. Version 5: the number of corners, while the
    // first number counts offsets.
    const int64_t second = in.count(1, "numbers");
    CellLists cells;
    // The keyword OFFSETS tells the two forms apart better than the version line, which some
    // programs write wrongly.
    if (in_capitals(in.peek()) != "OFFSETS") {
        const std::vector<int64_t> numbers = read_integers(in, second);
        cells.offsets.push_back(0);
        for (size_t i = 0; i < numbers.size(); i += static_cast<size_t>(numbers[i]) + 1) {
            // The count of a cell leads to the next one, so a wrong one must not lead out of the
            // list.
            if (numbers[i] < 0 || static_cast<size_t>(numbers[i]) >= numbers.size() - i)
                in.fail("a cell has more corners than there are");
            for (size_t c = 1; c <= static_cast<size_t>(numbers[i]); ++c)
                cells.corners.push_back(numbers[i + c]);
            cells.offsets.push_back(static_cast<int64_t>(cells.corners.size()));
        }
        if (static_cast<int64_t>(cells.offsets.size()) != first + 1)
            in.fail("there " + std::string(is_or_are(first)) + " not " + counted(first, "cell"));
        return cells;
    }
    in.skip_line();
    cells.offsets = read_integers(in, first);
    if (in_capitals(in.word()) != "CONNECTIVITY")
        in.fail("CONNECTIVITY must follow OFFSETS");
    in.skip_line();
    cells.corners = read_integers(in, second);
    return cells;
}

// SCALARS name type [components], with an optional LOOKUP_TABLE.
CellArray read_scalars(TextScanner& in, int64_t cells)
{
    CellArray array;
    array.name = in.word();
    in.word();
    const int64_t components = in.more_on_line() ? in.integer() : 1;
    // SCALARS have 1 to 4 components in "VTK File Formats".
    if (components < 1 || components > 4)
        in.fail("scalars have 1 to 4 components");
    in.skip_line();
    // Many programs leave the line out, though the format wants it.
    if (in_capitals(in.peek()) == "LOOKUP_TABLE")
        in.skip_line();
    array.values = read_reals(in, cells, components);
    array.components = components;
    return array;
}

// FIELD name arrays, each: name components tuples type.
void read_field(TextScanner& in, std::vector<CellArray>* arrays)
{
    in.word();
    const int64_t count = in.count(4, "arrays");
    for (int64_t i = 0; i < count; ++i) {
        CellArray array;
        array.name = in.word();
        array.components = in.integer();
        const int64_t tuples = in.integer();
        const std::string type = in_capitals(in.word());
        // Texts may contain blanks, so that they cannot be skipped by counting words. The limits
        // keep the product below within 64 bits.
        if (type == "STRING" || type == "VARIANT" || array.components < 1 || array.components > 1000 || tuples < 0 ||
            tuples > INT64_MAX / 1000)
            in.unsupported("array '" + array.name + "' cannot be read");
        array.values = read_reals(in, tuples, array.components);
        if (arrays)
            arrays->push_back(std::move(array));
    }
}

void read_vtk_header(TextScanner& in, const std::string& path)
{
    if (in.rest_of_line().substr(0, 14) != "# vtk DataFile")
        in.fail("a VTK file begins with '# vtk DataFile'");
    // The title, which may be anything.
    in.skip_line();
    // Cleft writes binary meshes as .vtu. The message names that way out.
    if (in_capitals(in.word()) != "ASCII")
        in.unsupported("binary legacy files cannot be read: write '" + path + "' as text or as .vtu");
    if (in_capitals(in.word()) != "DATASET" || in_capitals(in.word()) != "UNSTRUCTURED_GRID")
        in.unsupported("only an UNSTRUCTURED_GRID is a mesh of tetrahedra");
}

// What the sections have told so far.
struct VtkSections {
    MeshData mesh;
    CellLists cells;
    std::vector<CellArray> arrays;  // on cells
    int64_t values = 0;             // of each array of the section of data that is being read
    // Arrays on points are read and dropped, as the length of each must be known to find the next.
    bool of_cells = false;
};

// Takes a section of points and cells; false for another one.
bool take_geometry(TextScanner& in, const std::string& section, VtkSections& file)
{
    if (section == "POINTS") {
        const int64_t count = in.count(2, "points");
        in.word();
        file.mesh.points = read_reals(in, count, 3);
    } else if (section == "CELLS") {
        file.cells = read_cells(in);
    } else if (section == "CELL_TYPES") {
        const std::vector<int64_t> types = read_integers(in, in.integer());
        file.cells.types.assign(types.begin(), types.end());
    } else {
        return false;
    }
    return true;
}

// Takes the head of a section of data, or an array of it; false for something else.
bool take_data(TextScanner& in, const std::string& section, VtkSections& file)
{
    if (section == "CELL_DATA" || section == "POINT_DATA") {
        file.values = in.integer();
        if (file.values < 0 || file.values > INT32_MAX)
            in.fail("there cannot be " + std::to_string(file.values) + " values");
        file.of_cells = section == "CELL_DATA";
    } else if (section == "SCALARS") {
        CellArray array = read_scalars(in, file.values);
        if (file.of_cells)
            file.arrays.push_back(std::move(array));
    } else if (section == "VECTORS" || section == "NORMALS") {
        in.skip_line();
        read_reals(in, file.values, 3);
    } else if (section == "FIELD") {
        read_field(in, file.of_cells ? &file.arrays : nullptr);
    } else {
        return false;
    }
    return true;
}

}  // namespace

MeshData read_vtk(const std::string& path)
{
    TextScanner in(path);
    read_vtk_header(in, path);
    VtkSections file;
    while (!in.at_end()) {
        const std::string section = in_capitals(in.word());
        if (!take_geometry(in, section, file) && !take_data(in, section, file))
            in.unsupported("section " + section.substr(0, 40) + " cannot be read");
    }
    // Cells may stand before the points in the file, so that corners are checked at the end.
    naming_file(path, [&] { take_tetrahedra(file.cells, file.arrays, file.mesh); });
    return std::move(file.mesh);
}

}  // namespace cleft::io
