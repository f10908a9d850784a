// Finds the arrays of an unstructured grid by their sections, and reads them.
#include "io/vtu_piece.hpp"

#include "base/error.hpp"
#include "io/label_names.hpp"
#include "io/vtk_array.hpp"

#include <charconv>
#include <limits>

namespace cleft::io
{

namespace
{

struct VtuFile {
    VtkEncoding encoding;
    std::vector<XmlTag> points;
    std::vector<XmlTag> cells;
    std::vector<XmlTag> cell_data;
    std::vector<XmlTag> point_data;
    std::vector<XmlTag> field_data;
    int64_t point_count = -1;
    int64_t cell_count = -1;
};

int64_t count_of(const XmlTag& piece, const std::string& attribute)
{
    // The core numbers points in 32 bits, so a larger count cannot be read anyway.
    const std::string text = piece.get(attribute);
    int64_t count = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || end != text.data() + text.size() || count < 0 ||
        count > std::numeric_limits<int32_t>::max())
        throw Error(CLEFT_ERROR_FORMAT, attribute + "=\"" + text + "\" is no number of points or cells");
    return count;
}

void read_piece(const XmlTag& tag, VtuFile& file)
{
    // Pieces are the shares of parallel processes. Their common points would have to be merged.
    if (file.point_count >= 0)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "only files of one piece can be read");
    file.point_count = count_of(tag, "NumberOfPoints");
    file.cell_count = count_of(tag, "NumberOfCells");
}

// The arrays of a section that is read, or null.
std::vector<XmlTag>* section_of(std::string_view name, VtuFile& file)
{
    return name == "Points"      ? &file.points
           : name == "Cells"     ? &file.cells
           : name == "CellData"  ? &file.cell_data
           : name == "PointData" ? &file.point_data
           : name == "FieldData" ? &file.field_data
                                 : nullptr;
}

VtuFile scan(std::string_view text)
{
    VtuFile file;
    XmlScanner scanner(text);
    std::vector<XmlTag>* section = nullptr;
    bool known = false;
    for (XmlTag tag; scanner.next(tag);) {
        const std::string_view name = tag.name;
        if (name == "VTKFile") {
            if (tag.get("type") != "UnstructuredGrid")
                throw Error(CLEFT_ERROR_UNSUPPORTED, "only an UnstructuredGrid is a mesh of tetrahedra");
            file.encoding = vtk_encoding_of(tag);
            known = true;
        } else if (name == "Piece") {
            read_piece(tag, file);
        } else if (section_of(name, file)) {
            section = section_of(name, file);
        } else if (name.substr(0, 1) == "/" && section_of(name.substr(1), file)) {
            section = nullptr;
        } else if (name == "DataArray" && section) {
            section->push_back(tag);
        } else if (name == "AppendedData") {
            find_vtk_appended_data(text, tag, file.encoding);
            break;  // behind them nothing is XML any more
        }
    }
    if (!known || file.point_count < 0)
        throw Error(CLEFT_ERROR_FORMAT, "this is no VTK file with a piece of an unstructured grid");
    return file;
}

const XmlTag& find(const std::vector<XmlTag>& arrays, const std::string& name)
{
    for (const XmlTag& array : arrays)
        if (array.get("Name") == name)
            return array;
    throw Error(CLEFT_ERROR_FORMAT, "the array '" + name + "' is missing");
}

CellLists read_cells(const VtuFile& file)
{
    CellLists cells;
    cells.offsets = read_vtk_integers(find(file.cells, "offsets"), file.encoding, file.cell_count);
    // The file gives the end of each cell; the lists here begin with 0, too.
    cells.offsets.insert(cells.offsets.begin(), 0);
    cells.corners = read_vtk_integers(find(file.cells, "connectivity"), file.encoding, cells.offsets.back());
    const std::vector<int64_t> types = read_vtk_integers(find(file.cells, "types"), file.encoding, file.cell_count);
    cells.types.assign(types.begin(), types.end());
    return cells;
}

// Those of one component that hold numbers. Arrays of strings are for people.
std::vector<CellArray> read_number_arrays(const VtuFile& file)
{
    std::vector<CellArray> arrays;
    for (const XmlTag& tag : file.cell_data) {
        const std::string components = tag.get("NumberOfComponents");
        const bool is_number = tag.get("type").find("String") == std::string::npos;
        if (is_number && (components.empty() || components == "1"))
            arrays.push_back({tag.get("Name"), 1, read_vtk_reals(tag, file.encoding, file.cell_count)});
    }
    return arrays;
}

}  // namespace

VtuPiece read_vtu_piece(std::string_view text)
{
    const VtuFile file = scan(text);
    VtuPiece piece;
    if (file.points.empty())
        throw Error(CLEFT_ERROR_FORMAT, "the points are missing");
    piece.points = read_vtk_reals(file.points.front(), file.encoding, 3 * file.point_count);
    check_finite(piece.points);
    piece.arrays = read_number_arrays(file);
    piece.cells = read_cells(file);
    for (const XmlTag& tag : file.point_data)
        if (tag.get("Name") == "GlobalPointIds")
            piece.numbers = read_vtk_integers(tag, file.encoding, file.point_count);
    for (const XmlTag& tag : file.field_data) {
        int32_t label = 0;
        std::string name;
        // Names of labels as write_vtu() stores them. Field data of other programs are passed over.
        if (label_of_material_name(tag.get("Name"), label, name) && !name.empty())
            piece.names.emplace(label, name);
    }
    return piece;
}

}  // namespace cleft::io
