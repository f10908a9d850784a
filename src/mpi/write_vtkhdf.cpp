// VTKHDF, the one file of all ranks: an unstructured grid of version 1.0 in one partition. Rows lie in the order of the
// numbers in the whole mesh, in one block for each array, and no time is noted, so the bytes do not depend on the
// ranks.
//   The first rank makes the file, with room for all rows. Then each rank writes its rows where they belong. HDF5 is
// done by then: ranks that write by it together wait for each other, for ever if one of them finds the disk full.
#include "base/error.hpp"
#include "io/quiet_write.hpp"
#include "io/system_failure.hpp"
#include "mpi/hdf5.hpp"
#include "mpi/part_writers.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

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

Hdf5Id new_file(const std::string& path)
{
    const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
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

// Where the rows of the arrays of the grid begin in the file, in bytes.
struct Places {
    int64_t number_of_points, number_of_cells, number_of_corners, points, corners, ends, types, material;
    int64_t end;  // of the last
};

// Makes a data set of so many rows, none of which is written, and says where they begin.
int64_t place_of_rows(hid_t parent, const char* name, hid_t type, int64_t rows, hsize_t columns = 1)
{
    const Hdf5Id list = untimed(H5P_DATASET_CREATE);
    checked_hdf5(H5Pset_layout(list, H5D_CONTIGUOUS));
    checked_hdf5(H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY));
    checked_hdf5(H5Pset_fill_time(list, H5D_FILL_TIME_NEVER));
    const hsize_t extent[2] = {static_cast<hsize_t>(rows), columns};
    const Hdf5Id space(H5Screate_simple(columns > 1 ? 2 : 1, extent, nullptr), H5Sclose);
    const Hdf5Id made(H5Dcreate2(parent, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
    const haddr_t place = H5Dget_offset(made);
    if (place == HADDR_UNDEF)
        throw_hdf5_failure();
    return static_cast<int64_t>(place);
}

Places make_grid(const std::string& path, int64_t points, int64_t tets)
{
    Hdf5Id file = new_file(path);
    Places at{};
    {
        const Hdf5Id grid = group(file, "VTKHDF");
        describe_as_grid(grid);
        const Hdf5Id cell_data = group(grid, "CellData");
        at.number_of_points = place_of_rows(grid, "NumberOfPoints", H5T_STD_I64LE, 1);
        at.number_of_cells = place_of_rows(grid, "NumberOfCells", H5T_STD_I64LE, 1);
        at.number_of_corners = place_of_rows(grid, "NumberOfConnectivityIds", H5T_STD_I64LE, 1);
        at.points = place_of_rows(grid, "Points", H5T_IEEE_F64LE, points, 3);
        at.corners = place_of_rows(grid, "Connectivity", H5T_STD_I64LE, 4 * tets);
        at.ends = place_of_rows(grid, "Offsets", H5T_STD_I64LE, tets + 1);
        at.types = place_of_rows(grid, "Types", H5T_STD_U8LE, tets);
        at.material = place_of_rows(cell_data, "material", H5T_STD_I32LE, tets);
    }
    at.end = at.material + tets * int64_t{sizeof(int32_t)};
    file.close();
    return at;
}

// The file as a rank writes it. What fails names the path.
class RowFile
{
public:
    // `flags` as of open(), such as O_CREAT.
    explicit RowFile(const std::string& path, int flags = 0)
        : path_(path), descriptor_(open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666))
    {
        require(descriptor_ >= 0, errno);
    }
    ~RowFile() { close(descriptor_); }
    RowFile(const RowFile&) = delete;
    RowFile& operator=(const RowFile&) = delete;

    // A full disk is found before anybody writes.
    void reserve(int64_t size)
    {
        const int error = posix_fallocate(descriptor_, 0, size);
        // Some file systems cannot.
        require(error == 0 || error == EOPNOTSUPP || error == EINVAL, error);
    }
    template <class T>
    void write(int64_t place, const T* items, int64_t count)
    {
        require(lseek(descriptor_, place, SEEK_SET) == place, errno);
        const int error =
            io::write_quietly(descriptor_, reinterpret_cast<const char*>(items), to_size(count) * sizeof(T));
        require(error == 0, error);
    }
    // To the disk, as far as this machine has it.
    void flush() { require(fsync(descriptor_) == 0, errno); }

private:
    void require(bool is_done, int error) const
    {
        if (!is_done)
            io::throw_system_failure("cannot write '" + path_ + "'", error);
    }

    const std::string path_;
    const int descriptor_;
};

// Memory for what is converted.
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

void write_own_rows(const PartView& part, const Places& at, RowFile& file, const Writing& writing)
{
    const cleft_part_counts& n = part.counts;
    Converted room(n.owned_tets);
    const auto points_first = [&](double done) { writing.report(0.3 * done); };
    const auto tets_then = [&](double done) { writing.report(0.3 + 0.7 * done); };
    constexpr int64_t kLong = sizeof(int64_t), kPoint = 3 * sizeof(double), kLabel = sizeof(int32_t);
    in_turns(n.owned_points, points_first, [&](int64_t first, int64_t count) {
        file.write(at.points + kPoint * (n.first_point + first), part.points + 3 * first, 3 * count);
    });
    in_turns(n.owned_tets, tets_then, [&](int64_t first, int64_t count) {
        for (int64_t i = 0; i < 4 * count; ++i)
            room.corners[to_size(i)] = part.numbers[part.tets[4 * first + i]];
        for (int64_t i = 0; i < count; ++i)
            room.ends[to_size(i)] = 4 * (n.first_tet + first + i);
        const int64_t number = n.first_tet + first;
        file.write(at.corners + 4 * kLong * number, room.corners.data(), 4 * count);
        file.write(at.ends + kLong * number, room.ends.data(), count);
        file.write(at.types + number, room.types.data(), count);
        file.write(at.material + kLabel * number, part.labels + first, count);
    });
    if (n.rank != 0)
        return;
    const int64_t all_corners = 4 * n.all_tets;
    file.write(at.ends + kLong * n.all_tets, &all_corners, 1);
    file.write(at.number_of_points, &n.all_points, 1);
    file.write(at.number_of_cells, &n.all_tets, 1);
    file.write(at.number_of_corners, &all_corners, 1);
}

int64_t bytes_of_rows(int64_t points, int64_t tets)
{
    constexpr int64_t kPoint = 3 * sizeof(double), kTet = 5 * sizeof(int64_t) + sizeof(uint8_t) + sizeof(int32_t);
    return kPoint * points + kTet * tets;
}

// On the first rank.
Places make_file(const PartView& part, const std::string& path)
{
    // Where a disk is full or files are limited, HDF5 cannot close its file, and ends the process when it ends itself.
    // So there must be room before it begins.
    constexpr int64_t kBeside = 1 << 16;  // what else is in the file takes a few thousand bytes
    const int64_t points = part.counts.all_points, tets = part.counts.all_tets;
    RowFile(path, O_CREAT).reserve(bytes_of_rows(points, tets) + kBeside);
    const QuietHdf5 quiet;
    Places at{};
    try {
        at = make_grid(path, points, tets);
    } catch (const Error& error) {
        throw Error(error.status(), "cannot write '" + path + "': " + error.what());
    }
    RowFile(path).reserve(at.end);
    return at;
}

}  // namespace

std::vector<std::string> write_vtkhdf(const PartView& part, const Writing& writing)
{
    const io::SizeSignalBlocked no_signal;
    const std::string path = writing.stage.place(writing.stage.name());
    Array<Places> places;
    if (part.counts.rank == 0)
        places.push_back(make_file(part, path));
    // Others begin when the file is there.
    places = writing.exchange.all_gather(places);
    RowFile file(path);
    write_own_rows(part, places.front(), file, writing);
    file.flush();
    return {writing.stage.name()};
}

}  // namespace cleft::mpi
