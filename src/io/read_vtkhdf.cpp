// VTKHDF, unstructured grids: one partition after the other in the same arrays.
#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/cell_labels.hpp"
#include "io/hdf5_dataset.hpp"
#include "io/hdf5_group.hpp"
#include "io/label_names.hpp"
#include "io/mesh_data.hpp"
#include "io/shared_points.hpp"
#include "io/text_scanner.hpp"

#include <limits>
#include <map>
#include <numeric>

namespace cleft::io
{

namespace
{

[[noreturn]] void fail_hdf(const std::string& what) { throw Error(CLEFT_ERROR_FORMAT, what); }

// A group of the file, and what it has by name.
struct Hdf5Group {
    const Hdf5File& file;
    std::map<std::string, uint64_t> members;

    Hdf5Group(const Hdf5File& in, uint64_t object) : file(in), members(hdf5_members(in, object)) {}

    bool has(const std::string& name) const { return members.count(name) > 0; }
    uint64_t object(const std::string& name) const
    {
        const auto found = members.find(name);
        if (found == members.end())
            fail_hdf("'" + name + "' is missing");
        return found->second;
    }
    Hdf5Dataset dataset(const std::string& name) const { return {file, object(name), name}; }
    // Without members if there is no such group.
    Hdf5Group group(const std::string& name) const
    {
        return has(name) ? Hdf5Group(file, object(name)) : Hdf5Group(file);
    }

private:
    explicit Hdf5Group(const Hdf5File& in) : file(in) {}
};

// How many of something each partition has.
struct PartitionCounts {
    std::vector<int64_t> points, cells, corners;

    size_t partitions() const { return points.size(); }
    static uint64_t sum(const std::vector<int64_t>& counts)
    {
        return static_cast<uint64_t>(std::accumulate(counts.begin(), counts.end(), int64_t{0}));
    }
};

std::vector<int64_t> read_counts(const Hdf5Group& grid, const std::string& name)
{
    const Hdf5Dataset data = grid.dataset(name);
    std::vector<int64_t> counts = data.integers(data.rows(), 1);
    // The core numbers points in 32 bits, so a larger mesh cannot be read anyway.
    int64_t sum = 0;
    for (const int64_t count : counts) {
        constexpr int64_t kMost = 4 * int64_t{std::numeric_limits<int32_t>::max()};
        if (count < 0 || count > kMost || sum > kMost)
            fail_hdf("'" + name + "' is no number of points, cells or corners of a mesh that Cleft can hold");
        sum += count;
    }
    return counts;
}

PartitionCounts read_partitions(const Hdf5Group& grid)
{
    PartitionCounts counts{read_counts(grid, "NumberOfPoints"), read_counts(grid, "NumberOfCells"),
                           read_counts(grid, "NumberOfConnectivityIds")};
    if (counts.cells.size() != counts.partitions() || counts.corners.size() != counts.partitions())
        fail_hdf("its lists of partitions have different lengths");
    for (const auto* list : {&counts.points, &counts.cells})
        if (PartitionCounts::sum(*list) > std::numeric_limits<int32_t>::max())
            fail_hdf("it has more points or cells than 32 bits count");
    return counts;
}

// Each partition counts its points and corners from 0: now all are counted together.
void join_partitions(const PartitionCounts& counts, const std::vector<int64_t>& offsets, CellLists& cells)
{
    int64_t first_point = 0, first_corner = 0;
    size_t at = 0;
    cells.offsets.push_back(0);
    for (size_t p = 0; p < counts.partitions(); ++p) {
        const auto cells_here = static_cast<size_t>(counts.cells[p]);
        if (offsets[at] != 0 || offsets[at + cells_here] != counts.corners[p])
            fail_hdf("the offsets of the " + ordinal(static_cast<int64_t>(p)) + " partition do not fit its corners");
        for (size_t c = 1; c <= cells_here; ++c) {
            if (offsets[at + c] < 0 || offsets[at + c] > counts.corners[p])
                fail_hdf("an offset of the " + ordinal(static_cast<int64_t>(p)) + " partition is outside of it");
            cells.offsets.push_back(first_corner + offsets[at + c]);
        }
        at += cells_here + 1;
        for (int64_t i = first_corner; i < first_corner + counts.corners[p]; ++i) {
            int64_t& corner = cells.corners[static_cast<size_t>(i)];
            if (corner < 0 || corner >= counts.points[p])
                fail_hdf("the " + ordinal(static_cast<int64_t>(p)) + " partition names point " +
                         std::to_string(corner) + " of the " + std::to_string(counts.points[p]) +
                         " that are counted from 0");
            corner += first_point;
        }
        first_point += counts.points[p];
        first_corner += counts.corners[p];
    }
}

constexpr char kGhostArray[] = "vtkGhostType";

// Partitions may repeat cells of their neighbours.
void pass_over_ghosts(const Hdf5Group& cell_data, CellLists& cells)
{
    constexpr int64_t kDuplicateCell = 1;  // vtkDataSetAttributes::DUPLICATECELL
    constexpr int32_t kEmptyCell = 0;
    if (!cell_data.has(kGhostArray))
        return;
    const std::vector<int64_t> ghosts = cell_data.dataset(kGhostArray).integers(cells.types.size(), 1);
    for (size_t c = 0; c < cells.types.size(); ++c)
        if (ghosts[c] & kDuplicateCell)
            cells.types[c] = kEmptyCell;
}

CellLists read_grid_cells(const Hdf5Group& grid, const PartitionCounts& counts)
{
    CellLists cells;
    const uint64_t count = PartitionCounts::sum(counts.cells);
    cells.corners = grid.dataset("Connectivity").integers(PartitionCounts::sum(counts.corners), 1);
    const std::vector<int64_t> offsets = grid.dataset("Offsets").integers(count + counts.partitions(), 1);
    join_partitions(counts, offsets, cells);
    const std::vector<int64_t> types = grid.dataset("Types").integers(count, 1);
    cells.types.assign(types.begin(), types.end());
    if (counts.partitions() > 1)
        pass_over_ghosts(grid.group("CellData"), cells);
    return cells;
}

// Those that may be labels, in the order of their names.
std::vector<CellArray> read_cell_arrays(const Hdf5Group& cell_data, uint64_t cells)
{
    std::vector<CellArray> arrays;
    for (const auto& [name, object] : cell_data.members) {
        // Our own array needs no others beside it, which may be large.
        if (name == kGhostArray || (name != "material" && cell_data.has("material")))
            continue;
        const Hdf5Dataset data(cell_data.file, object, name);
        if (data.holds_numbers() && data.columns() == 1)
            arrays.push_back({name, 1, data.reals(cells, 1)});
        else if (name == "material")
            arrays.push_back({name, static_cast<int64_t>(data.columns()), {}});
    }
    return arrays;
}

// What the user can do with another kind.
std::string way_of_kind(const std::string& kind)
{
    return kind == "ImageData"  ? "in ParaView, save its data as .vtk (legacy), which is meshed as a volume"
           : kind == "PolyData" ? "it is a surface: make a label map of it, and mesh that"
                                : "in ParaView, save the tetrahedra in it as .vtu";
}

void check_kind(const Hdf5File& file, uint64_t grid)
{
    const std::string kind = hdf5_text_attribute(file, grid, "Type");
    if (kind != "UnstructuredGrid")
        throw Error(CLEFT_ERROR_UNSUPPORTED, "only an UnstructuredGrid is a mesh of tetrahedra, and this is '" + kind +
                                                 "': " + way_of_kind(kind));
    const std::vector<int64_t> version = hdf5_integer_attribute(file, grid, "Version");
    if (version.empty() || version[0] < 1 || version[0] > 2)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it is VTKHDF of version " +
                                                 (version.empty() ? "''" : std::to_string(version[0])) +
                                                 ", and only 1 and 2 can be read");
}

// A file of one step is as one without.
void check_steps(const Hdf5Group& grid)
{
    if (!grid.has("Steps"))
        return;
    const std::vector<int64_t> steps = hdf5_integer_attribute(grid.file, grid.object("Steps"), "NSteps");
    if (steps.size() != 1 || steps[0] != 1)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it has several steps of time, and only one mesh can be read");
}

MeshData read_grid(const Hdf5Group& grid)
{
    check_steps(grid);
    const PartitionCounts counts = read_partitions(grid);
    MeshData mesh;
    mesh.points = grid.dataset("Points").reals(PartitionCounts::sum(counts.points), 3);
    check_finite(mesh.points);
    take_tetrahedra(read_grid_cells(grid, counts),
                    read_cell_arrays(grid.group("CellData"), PartitionCounts::sum(counts.cells)), mesh);
    if (counts.partitions() > 1)
        join_shared_points(counts.points, mesh);
    for (const auto& [title, object] : grid.group("FieldData").members) {
        int32_t label = 0;
        std::string name;
        // As write_vtu() stores names of labels.
        if (label_of_material_name(title, label, name) && !name.empty())
            mesh.names.emplace(label, name);
    }
    return mesh;
}

MeshData read_file(const Hdf5File& file)
{
    const Hdf5Group root(file, file.root());
    if (!root.has("VTKHDF"))
        fail_hdf("this HDF5 file has no group 'VTKHDF', so it is no mesh of VTK");
    const uint64_t grid = root.object("VTKHDF");
    check_kind(file, grid);
    return read_grid(Hdf5Group(file, grid));
}

}  // namespace

MeshData read_vtkhdf(const std::string& path)
{
    return naming_file(path, [&] { return read_file(Hdf5File(path)); });
}

}  // namespace cleft::io
