// VTK XML in pieces: each rank writes one, a .vtu whose arrays are appended and raw, and rank 0 writes the list of
// them.
#include "io/atomic_file.hpp"
#include "io/xml_scanner.hpp"
#include "mpi/part_writers.hpp"
#include "mpi/piece_names.hpp"

#include <algorithm>

namespace cleft::mpi
{

namespace
{

// An array of a piece: the list has the same element without an offset.
struct Declared {
    const char* type;
    const char* name;
    int components;
    int64_t item_bytes;

    std::string element(const char* kind, const std::string& rest) const
    {
        return std::string("<") + kind + " type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
               std::to_string(components) + "\"" + rest + "/>\n";
    }
};

constexpr Declared kPointPlaces{"Float64", "Points", 3, 24};
constexpr Declared kPointNumbers{"Int64", "GlobalPointIds", 1, 8};
constexpr Declared kPointOwners{"Int32", "owner", 1, 4};
constexpr Declared kCellCorners{"Int32", "connectivity", 1, 16};
constexpr Declared kCellEnds{"Int64", "offsets", 1, 8};
constexpr Declared kCellTypes{"UInt8", "types", 1, 1};
constexpr Declared kCellMaterial{"Int32", "material", 1, 4};
constexpr Declared kCellGhosts{"UInt8", "vtkGhostType", 1, 1};

// The elements of a piece, with the places of their arrays.
class Head
{
public:
    std::string add(const Declared& array, int64_t items)
    {
        std::string element =
            array.element("DataArray", " format=\"appended\" offset=\"" + std::to_string(offset_) + "\"");
        // The bytes of an array follow their number.
        offset_ += int64_t{sizeof(uint64_t)} + items * array.item_bytes;
        return element;
    }

private:
    int64_t offset_ = 0;
};

std::string elements_of(const PartView& part, bool has_ghosts)
{
    const int64_t points = part.counts.points, tets = part.counts.tets;
    Head head;
    std::string text =
        "<Piece NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(tets) + "\">\n";
    text += "<Points>\n" + head.add(kPointPlaces, points) + "</Points>\n";
    text += "<PointData GlobalIds=\"GlobalPointIds\">\n" + head.add(kPointNumbers, points);
    text += head.add(kPointOwners, points) + "</PointData>\n";
    text += "<Cells>\n" + head.add(kCellCorners, tets);
    text += head.add(kCellEnds, tets);
    text += head.add(kCellTypes, tets) + "</Cells>\n";
    text += "<CellData Scalars=\"material\">\n" + head.add(kCellMaterial, tets);
    if (has_ghosts)
        text += head.add(kCellGhosts, tets);
    return text + "</CellData>\n</Piece>\n";
}

// In the order of elements_of().
void write_arrays(const PartView& part, bool has_ghosts, io::AtomicFile& file)
{
    constexpr uint8_t kTetOfVtk = 10, kDuplicateCell = 1;
    const int64_t points = part.counts.points, tets = part.counts.tets;
    const auto begin = [&](const Declared& array, int64_t items) {
        file.binary(static_cast<uint64_t>(items * array.item_bytes));
    };
    const auto write = [&](const Declared& array, const void* items, int64_t count) {
        begin(array, count);
        file.write(items, to_size(count * array.item_bytes));
    };
    write(kPointPlaces, part.points, points);
    write(kPointNumbers, part.numbers, points);
    write(kPointOwners, part.owners, points);
    write(kCellCorners, part.tets, tets);
    begin(kCellEnds, tets);
    for (int64_t t = 0; t < tets; ++t)
        file.binary(4 * (t + 1));
    begin(kCellTypes, tets);
    for (int64_t t = 0; t < tets; ++t)
        file.binary(kTetOfVtk);
    write(kCellMaterial, part.labels, tets);
    if (!has_ghosts)
        return;
    begin(kCellGhosts, tets);
    for (int64_t t = 0; t < tets; ++t)
        file.binary(t < part.counts.owned_tets ? uint8_t{0} : kDuplicateCell);
}

constexpr const char* kXmlHead = "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";

void write_piece(const PartView& part, bool has_ghosts, const std::string& path)
{
    io::AtomicFile file(path);
    file.print("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid", kXmlHead, "<UnstructuredGrid>\n",
               elements_of(part, has_ghosts), "</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    write_arrays(part, has_ghosts, file);
    file.print("\n</AppendedData>\n</VTKFile>\n");
    file.commit();
}

void write_list(bool has_ghosts, const std::vector<std::string>& pieces, const std::string& path)
{
    const auto element = [](const Declared& array) { return array.element("PDataArray", ""); };
    io::AtomicFile file(path);
    file.print("<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid", kXmlHead,
               "<PUnstructuredGrid GhostLevel=\"", has_ghosts ? 1 : 0, "\">\n<PPoints>\n", element(kPointPlaces),
               "</PPoints>\n<PPointData GlobalIds=\"GlobalPointIds\">\n", element(kPointNumbers), element(kPointOwners),
               "</PPointData>\n<PCellData Scalars=\"material\">\n", element(kCellMaterial),
               has_ghosts ? element(kCellGhosts) : "", "</PCellData>\n");
    for (const std::string& piece : pieces)
        file.print("<Piece Source=\"", io::to_xml(piece), "\"/>\n");
    file.print("</PUnstructuredGrid>\n</VTKFile>\n");
    file.commit();
}

}  // namespace

std::vector<std::string> write_pvtu(const PartView& part, const Writing& writing)
{
    std::vector<std::string> names;
    names.reserve(to_size(writing.exchange.ranks() + 1));
    for (int32_t r = 0; r < writing.exchange.ranks(); ++r)
        names.push_back(name_of_vtu_piece(writing.stage.name(), r));
    // An array that one piece has, all have.
    bool has_ghosts = false;
    for (const int64_t ghosts : writing.exchange.all_gather(part.counts.tets - part.counts.owned_tets))
        has_ghosts = has_ghosts || ghosts > 0;
    writing.report(0);
    if (writing.exchange.rank() == 0)
        write_list(has_ghosts, names, writing.stage.place(writing.stage.name()));
    write_piece(part, has_ghosts, writing.stage.place(names[to_size(writing.exchange.rank())]));
    names.push_back(writing.stage.name());
    return names;
}

}  // namespace cleft::mpi
