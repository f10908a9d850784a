// VTK XML in pieces: a list of files, each with the share of one process. Points that several of them have become one.
#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/mesh_data.hpp"
#include "io/shared_points.hpp"
#include "io/text_scanner.hpp"
#include "io/vtu_piece.hpp"
#include "io/xml_scanner.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>

namespace cleft::io
{

namespace
{

constexpr char kGhostsOfPiece[] = "vtkGhostType";

std::vector<std::string> sources_of(std::string_view text)
{
    std::vector<std::string> sources;
    bool is_list = false;
    XmlScanner scanner(text);
    for (XmlTag tag; scanner.next(tag);) {
        if (tag.name == "VTKFile" && tag.get("type") != "PUnstructuredGrid")
            throw Error(CLEFT_ERROR_UNSUPPORTED, "only a PUnstructuredGrid is a list of pieces with tetrahedra");
        is_list |= tag.name == "VTKFile";
        if (tag.name == "Piece") {
            sources.push_back(tag.get("Source"));
            if (sources.back().empty())
                throw Error(CLEFT_ERROR_FORMAT,
                            "the " + ordinal(static_cast<int64_t>(sources.size()) - 1) + " piece names no file");
        }
    }
    if (!is_list || sources.empty())
        throw Error(CLEFT_ERROR_FORMAT, "this is no VTK file with a list of pieces");
    // A short list of one file again and again would take any amount of memory.
    std::vector<std::string> sorted = sources;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        throw Error(CLEFT_ERROR_FORMAT, "two pieces are the same file, '" + *twice + "'");
    return sources;
}

// Names of files are relative to the folder of the list. A list of a stranger may name a device, which has no end.
std::string path_of_source(const std::string& list, const std::string& source)
{
    std::string path = source[0] == '/' ? source : list.substr(0, list.find_last_of('/') + 1) + source;
    std::error_code error;
    const auto kind = std::filesystem::status(path, error).type();
    if (kind != std::filesystem::file_type::regular && kind != std::filesystem::file_type::not_found)
        throw Error(CLEFT_ERROR_FILE, "'" + path + "' is a piece, and must be a regular file");
    return path;
}

// An array of the piece by its name, or null.
const CellArray* array_of(const VtuPiece& piece, const std::string& name)
{
    const auto found = std::find_if(piece.arrays.begin(), piece.arrays.end(),
                                    [&](const CellArray& array) { return array.name == name; });
    return found == piece.arrays.end() ? nullptr : &*found;
}

// Pieces may repeat cells of their neighbours.
void pass_over_ghosts_of(VtuPiece& piece)
{
    constexpr int64_t kDuplicate = 1;  // vtkDataSetAttributes::DUPLICATECELL
    if (const CellArray* ghosts = array_of(piece, kGhostsOfPiece))
        for (size_t c = 0; c < std::min(piece.cells.types.size(), ghosts->values.size()); ++c)
            if (is_label(ghosts->values[c]) && static_cast<int64_t>(ghosts->values[c]) & kDuplicate)
                piece.cells.types[c] = 0;  // an empty cell
}

// Corners and offsets of a piece count from its own first.
void append_cells(const VtuPiece& piece, int64_t first_point, CellLists& all)
{
    const auto first_corner = static_cast<int64_t>(all.corners.size());
    for (size_t c = 1; c < piece.cells.offsets.size(); ++c) {
        const int64_t end = piece.cells.offsets[c];
        if (end < 0 || end > static_cast<int64_t>(piece.cells.corners.size()))
            throw Error(CLEFT_ERROR_FORMAT, "an offset of a piece is outside of it");
        all.offsets.push_back(first_corner + end);
    }
    for (const int64_t corner : piece.cells.corners) {
        if (corner < 0 || corner >= piece.point_count())
            throw Error(CLEFT_ERROR_FORMAT, "a piece names point " + std::to_string(corner) + " of the " +
                                                std::to_string(piece.point_count()) + " that are counted from 0");
        all.corners.push_back(first_point + corner);
    }
    all.types.insert(all.types.end(), piece.cells.types.begin(), piece.cells.types.end());
}

// Those that all pieces with cells have.
std::vector<CellArray> joined_arrays(const std::vector<VtuPiece>& pieces)
{
    std::vector<CellArray> all;
    const auto with_cells =
        std::find_if(pieces.begin(), pieces.end(), [](const VtuPiece& piece) { return !piece.cells.types.empty(); });
    if (with_cells == pieces.end())
        return all;
    for (const CellArray& first : with_cells->arrays) {
        CellArray joined{first.name, 1, {}};
        bool is_in_all = first.name != kGhostsOfPiece;
        for (const VtuPiece& piece : pieces) {
            const CellArray* const array = array_of(piece, first.name);
            is_in_all = is_in_all && (array || piece.cells.types.empty());
            if (array && is_in_all)
                joined.values.insert(joined.values.end(), array->values.begin(), array->values.end());
        }
        if (is_in_all)
            all.push_back(std::move(joined));
        else if (first.name == "material")
            throw Error(CLEFT_ERROR_FORMAT, "the array 'material' is missing in a piece");
    }
    return all;
}

MeshData joined_pieces(const std::vector<VtuPiece>& pieces)
{
    MeshData mesh;
    CellLists cells;
    cells.offsets.push_back(0);
    std::vector<int64_t> point_counts, numbers;
    for (const VtuPiece& piece : pieces) {
        append_cells(piece, static_cast<int64_t>(mesh.points.size() / 3), cells);
        mesh.points.insert(mesh.points.end(), piece.points.begin(), piece.points.end());
        mesh.names.insert(piece.names.begin(), piece.names.end());
        point_counts.push_back(piece.point_count());
        numbers.insert(numbers.end(), piece.numbers.begin(), piece.numbers.end());
    }
    constexpr auto kMost = static_cast<size_t>(std::numeric_limits<int32_t>::max());
    if (mesh.points.size() / 3 > kMost || cells.types.size() > kMost)
        throw Error(CLEFT_ERROR_TOO_LARGE, "its pieces have more points or cells than 32 bits count");
    take_tetrahedra(cells, joined_arrays(pieces), mesh);
    if (numbers.size() == mesh.points.size() / 3)
        join_points_of_numbers(numbers, mesh);
    else
        join_shared_points(point_counts, mesh);
    return mesh;
}

}  // namespace

MeshData read_pvtu(const std::string& path)
{
    const std::string list = read_whole_file(path);
    std::vector<VtuPiece> pieces;
    for (const std::string& source : naming_file(path, [&] { return sources_of(list); })) {
        const std::string file = path_of_source(path, source);
        const std::string text = read_whole_file(file);
        pieces.push_back(naming_file(file, [&] { return read_vtu_piece(text); }));
        pass_over_ghosts_of(pieces.back());
    }
    return naming_file(path, [&] { return joined_pieces(pieces); });
}

}  // namespace cleft::io
