// VTKHDF, the one file of all ranks: an unstructured grid of version 1.0 in one partition. Rows lie in the order of the
// numbers in the whole mesh, in one block for each array, and no time is noted, so the bytes do not depend on the
// ranks.
#include "base/error.hpp"
#include "io/quiet_write.hpp"
#include "mpi/hdf5.hpp"
#include "mpi/part_writers.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace cleft::mpi
{

namespace
{

// So many rows are converted and written at once: some tens of megabytes.
constexpr int64_t kRowsAtOnce = int64_t{1} << 20;

Hdf5Id untimed(hid_t kind)
{
    Hdf5Id list(H5Pcreate(kind), H5Pclose);
    checked_hdf5(H5Pset_obj_track_times(list, false));
    return list;
}

Hdf5Id shared_file(const std::string& path, MPI_Comm comm)
{
    const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    checked_hdf5(H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL));
    // One version of the format, whatever a later HDF5 would choose; all readers know it.
    checked_hdf5(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, untimed(H5P_FILE_CREATE), access), H5Fclose};
}

Hdf5Id group(hid_t parent, const char* name)
{
    return {H5Gcreate2(parent, name, H5P_DEFAULT, untimed(H5P_GROUP_CREATE), H5P_DEFAULT), H5Gclose};
}

void set_attribute(hid_t owner, const char* name, hid_t type, hid_t space, const void* value)
{
    const Hdf5Id attribute(H5Acreate2(owner, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    checked_hdf5(H5Awrite(attribute, type, value));
}

void describe_as_grid(hid_t grid)
{
    constexpr char kKind[] = "UnstructuredGrid";
    constexpr int64_t kVersion[2] = {1, 0};
    const hsize_t two = 2;
    const Hdf5Id pair(H5Screate_simple(1, &two, nullptr), H5Sclose);
    set_attribute(grid, "Version", H5T_STD_I64LE, pair, kVersion);
    const Hdf5Id text(H5Tcopy(H5T_C_S1), H5Tclose);
    checked_hdf5(H5Tset_size(text, sizeof kKind - 1));
    checked_hdf5(H5Tset_strpad(text, H5T_STR_NULLPAD));
    const Hdf5Id one(H5Screate(H5S_SCALAR), H5Sclose);
    set_attribute(grid, "Type", text, one, kKind);
}

// A data set of so many rows. All ranks make it; each writes rows of its own.
class Rows
{
public:
    Rows(hid_t parent, const char* name, hid_t type, int64_t rows, hsize_t columns)
        : type_(type),
          columns_(columns),
          space_(space(rows), H5Sclose),
          rows_(H5Dcreate2(parent, name, type, space_, H5P_DEFAULT, plain(), H5P_DEFAULT), H5Dclose)
    {
    }

    // Rows from number `first` on. The ranks do not wait for each other.
    void write(int64_t first, int64_t count, const void* data)
    {
        if (count == 0)
            return;
        const hsize_t start[2] = {static_cast<hsize_t>(first), 0};
        const hsize_t extent[2] = {static_cast<hsize_t>(count), columns_};
        checked_hdf5(H5Sselect_hyperslab(space_, H5S_SELECT_SET, start, nullptr, extent, nullptr));
        const Hdf5Id memory(space(count), H5Sclose);
        checked_hdf5(H5Dwrite(rows_, type_, memory, space_, H5P_DEFAULT, data));
    }

private:
    hid_t space(int64_t rows) const
    {
        const hsize_t extent[2] = {static_cast<hsize_t>(rows), columns_};
        return H5Screate_simple(columns_ > 1 ? 2 : 1, extent, nullptr);
    }
    static Hdf5Id plain()
    {
        Hdf5Id list = untimed(H5P_DATASET_CREATE);
        checked_hdf5(H5Pset_layout(list, H5D_CONTIGUOUS));
        // The places are known at once, and all bytes are written.
        checked_hdf5(H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY));
        checked_hdf5(H5Pset_fill_time(list, H5D_FILL_TIME_NEVER));
        return list;
    }

    hid_t type_;
    hsize_t columns_;
    Hdf5Id space_, rows_;
};

// The arrays of the grid, in the order in which they lie in the file.
struct GridArrays {
    Rows number_of_points, number_of_cells, number_of_corners, points, corners, ends, types, material;

    GridArrays(hid_t grid, hid_t cell_data, int64_t all_points, int64_t all_tets)
        : number_of_points(grid, "NumberOfPoints", H5T_STD_I64LE, 1, 1),
          number_of_cells(grid, "NumberOfCells", H5T_STD_I64LE, 1, 1),
          number_of_corners(grid, "NumberOfConnectivityIds", H5T_STD_I64LE, 1, 1),
          points(grid, "Points", H5T_IEEE_F64LE, all_points, 3),
          corners(grid, "Connectivity", H5T_STD_I64LE, 4 * all_tets, 1),
          ends(grid, "Offsets", H5T_STD_I64LE, all_tets + 1, 1),
          types(grid, "Types", H5T_STD_U8LE, all_tets, 1),
          material(cell_data, "material", H5T_STD_I32LE, all_tets, 1)
    {
    }
};

// Memory for what is converted, taken before the ranks depend on each other.
struct Converted {
    std::vector<int64_t> corners, ends;
    std::vector<uint8_t> types;
    explicit Converted(int64_t tets)
    {
        constexpr uint8_t kTetOfVtk = 10;
        const size_t most = to_size(std::min(tets, kRowsAtOnce));
        corners.resize(4 * most);
        ends.resize(most);
        types.assign(most, kTetOfVtk);
    }
};

// body(first, count) for pieces of so many rows, and then report(1).
template <class Body>
void in_turns(int64_t rows, const std::function<void(double)>& report, const Body& body)
{
    for (int64_t first = 0; first < rows; first += kRowsAtOnce) {
        report(static_cast<double>(first) / static_cast<double>(rows));
        body(first, std::min(kRowsAtOnce, rows - first));
    }
}

void write_own_rows(const PartView& part, GridArrays& arrays, Converted& room, const Writing& writing)
{
    const cleft_part_counts& n = part.counts;
    const auto points_first = [&](double done) { writing.report(0.3 * done); };
    const auto tets_then = [&](double done) { writing.report(0.3 + 0.7 * done); };
    in_turns(n.owned_points, points_first, [&](int64_t first, int64_t count) {
        arrays.points.write(n.first_point + first, count, part.points + 3 * first);
    });
    in_turns(n.owned_tets, tets_then, [&](int64_t first, int64_t count) {
        for (int64_t i = 0; i < 4 * count; ++i)
            room.corners[to_size(i)] = part.numbers[part.tets[4 * first + i]];
        for (int64_t i = 0; i < count; ++i)
            room.ends[to_size(i)] = 4 * (n.first_tet + first + i);
        arrays.corners.write(4 * (n.first_tet + first), 4 * count, room.corners.data());
        arrays.ends.write(n.first_tet + first, count, room.ends.data());
        arrays.types.write(n.first_tet + first, count, room.types.data());
        arrays.material.write(n.first_tet + first, count, part.labels + first);
    });
    if (n.rank != 0)
        return;
    const int64_t all_corners = 4 * n.all_tets;
    arrays.ends.write(n.all_tets, 1, &all_corners);
    arrays.number_of_points.write(0, 1, &n.all_points);
    arrays.number_of_cells.write(0, 1, &n.all_tets);
    arrays.number_of_corners.write(0, 1, &all_corners);
}

// To the disk, as far as this machine has it.
void flush_to_disk(const std::string& path)
{
    const int descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC);
    const bool is_flushed = descriptor >= 0 && fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0)
        close(descriptor);
    if (!is_flushed)
        throw Error(CLEFT_ERROR_FILE, std::generic_category().message(error));
}

void write_together(const PartView& part, const std::string& path, Converted& room, const Writing& writing)
{
    Hdf5Id file = shared_file(path, writing.mpi.comm());
    {
        const Hdf5Id grid = group(file, "VTKHDF");
        describe_as_grid(grid);
        const Hdf5Id cell_data = group(grid, "CellData");
        GridArrays arrays(grid, cell_data, part.counts.all_points, part.counts.all_tets);
        // A rank that fails here still closes the file with the others.
        write_own_rows(part, arrays, room, writing);
    }
    file.close();
    flush_to_disk(path);
}

}  // namespace

std::vector<std::string> write_vtkhdf(const PartView& part, const Writing& writing)
{
    const QuietHdf5 quiet;
    const io::SizeSignalBlocked no_signal;
    const std::string path = writing.stage.place(writing.stage.name());
    Converted room(part.counts.owned_tets);
    // From here on, ranks wait for each other in HDF5: one that had no memory would have others wait for ever.
    writing.exchange.all_gather(int64_t{0});
    try {
        write_together(part, path, room, writing);
    } catch (const Error& error) {
        if (error.status() != CLEFT_ERROR_FILE)
            throw;
        throw Error(CLEFT_ERROR_FILE, "cannot write '" + path + "': " + error.what());
    }
    return {writing.stage.name()};
}

}  // namespace cleft::mpi
