// HDF5 has the last dimension fastest, as C has: that is x.
#include "mpi/hdf5_voxels.hpp"

#include "base/error.hpp"
#include "io/system_failure.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <vector>

namespace cleft::mpi
{

namespace
{

Hdf5Id opened_file(const std::string& path)
{
    const QuietHdf5 quiet;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file >= 0)
        return {file, H5Fclose};
    // The system's words are shorter than those of HDF5.
    if (access(path.c_str(), R_OK) != 0)
        io::throw_system_failure("cannot read '" + path + "'", errno);
    throw Error(CLEFT_ERROR_FORMAT, "'" + path + "' is no HDF5 file, or is damaged");
}

bool holds_labels(hid_t data)
{
    const Hdf5Id space(H5Dget_space(data), H5Sclose), type(H5Dget_type(data), H5Tclose);
    return H5Sget_simple_extent_ndims(space) == 3 && H5Tget_class(type) == H5T_INTEGER && H5Tget_size(type) <= 8;
}

// The names of the data sets in the root group that can be label maps.
herr_t add_name(hid_t root, const char* name, const H5L_info_t* /*link*/, void* names)
{
    try {
        const Hdf5Id object(H5Oopen(root, name, H5P_DEFAULT), H5Oclose);
        if (H5Iget_type(object) == H5I_DATASET && holds_labels(object))
            static_cast<std::vector<std::string>*>(names)->emplace_back(name);
        return 0;
    } catch (...) {
        return -1;
    }
}

std::string only_dataset(hid_t file, const std::string& path)
{
    std::vector<std::string> names;
    hsize_t index = 0;
    checked_hdf5(H5Literate(file, H5_INDEX_NAME, H5_ITER_INC, &index, add_name, &names));
    if (names.empty())
        throw Error(CLEFT_ERROR_FORMAT,
                    "'" + path + "' has no data set with three dimensions and integers at its root");
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    if (names.size() > 1)
        throw Error(CLEFT_ERROR_FORMAT, "'" + path + "' has several data sets: " + list + "; name one of them");
    return names.front();
}

Hdf5Id opened_data(hid_t file, const std::string& path, std::string name)
{
    const QuietHdf5 quiet;
    if (name.empty())
        name = only_dataset(file, path);
    const hid_t data = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
    if (data < 0)
        throw Error(CLEFT_ERROR_FORMAT, "'" + path + "' has no data set '" + name + "'");
    Hdf5Id owner(data, H5Dclose);
    if (!holds_labels(data))
        throw Error(CLEFT_ERROR_FORMAT,
                    "'" + path + "': the data set '" + name + "' does not have three dimensions and integers");
    return owner;
}

cleft_type type_of_labels(size_t bytes, bool is_signed)
{
    if (bytes == 1)
        return is_signed ? CLEFT_TYPE_INT16 : CLEFT_TYPE_UINT8;
    if (bytes == 2)
        return is_signed ? CLEFT_TYPE_INT16 : CLEFT_TYPE_UINT16;
    return bytes <= 4 && !is_signed ? CLEFT_TYPE_UINT32 : CLEFT_TYPE_INT32;
}

hid_t memory_type(cleft_type type)
{
    switch (type) {
        case CLEFT_TYPE_UINT8:
            return H5T_NATIVE_UINT8;
        case CLEFT_TYPE_UINT16:
            return H5T_NATIVE_UINT16;
        case CLEFT_TYPE_INT16:
            return H5T_NATIVE_INT16;
        case CLEFT_TYPE_UINT32:
            return H5T_NATIVE_UINT32;
        default:
            return H5T_NATIVE_INT32;
    }
}

}  // namespace

Hdf5Voxels::Hdf5Voxels(const std::string& path, const std::string& dataset)
    : path_(path), file_(opened_file(path)), data_(opened_data(file_, path, dataset))
{
    const Hdf5Id space(H5Dget_space(data_), H5Sclose), type(H5Dget_type(data_), H5Tclose);
    hsize_t extent[3];
    checked_hdf5(H5Sget_simple_extent_dims(space, extent, nullptr));
    for (size_t i = 0; i < 3; ++i)
        dims_[i] = static_cast<int64_t>(extent[2 - i]);
    is_wide_ = H5Tget_size(type) > 4;
    type_ = type_of_labels(H5Tget_size(type), is_wide_ || H5Tget_sign(type) == H5T_SGN_2);
}

bool Hdf5Voxels::get_attribute(const char* name, std::array<double, 3>& out) const
{
    const QuietHdf5 quiet;
    if (H5Aexists(data_, name) <= 0)
        return false;
    const Hdf5Id attribute(H5Aopen(data_, name, H5P_DEFAULT), H5Aclose);
    const Hdf5Id space(H5Aget_space(attribute), H5Sclose);
    if (H5Sget_simple_extent_npoints(space) != 3 || H5Aread(attribute, H5T_NATIVE_DOUBLE, out.data()) < 0)
        throw Error(CLEFT_ERROR_FORMAT, "'" + path_ + "': the attribute '" + name + "' is not three numbers");
    return true;
}

void Hdf5Voxels::read(const int64_t first[3], const int64_t count[3], void* voxels) const
{
    const QuietHdf5 quiet;
    hsize_t start[3], extent[3];
    for (size_t i = 0; i < 3; ++i) {
        start[2 - i] = static_cast<hsize_t>(first[i]);
        extent[2 - i] = static_cast<hsize_t>(count[i]);
    }
    try {
        const Hdf5Id box(H5Dget_space(data_), H5Sclose);
        checked_hdf5(H5Sselect_hyperslab(box, H5S_SELECT_SET, start, nullptr, extent, nullptr));
        const Hdf5Id memory(H5Screate_simple(3, extent, nullptr), H5Sclose);
        if (is_wide_)
            read_narrowed(memory, box, count, static_cast<int32_t*>(voxels));
        else
            checked_hdf5(H5Dread(data_, memory_type(type_), memory, box, H5P_DEFAULT, voxels));
    } catch (const Error& error) {
        throw Error(error.status(), "cannot read '" + path_ + "': " + error.what());
    }
}

void Hdf5Voxels::read_narrowed(hid_t memory, hid_t box, const int64_t count[3], int32_t* voxels) const
{
    std::vector<int64_t> wide(static_cast<size_t>(count[0] * count[1] * count[2]));
    // Unsigned numbers that do not fit become the greatest that do, which is beyond 32 bits all the same.
    checked_hdf5(H5Dread(data_, H5T_NATIVE_INT64, memory, box, H5P_DEFAULT, wide.data()));
    const auto fits = [](int64_t label) { return label == static_cast<int32_t>(label); };
    if (!std::all_of(wide.begin(), wide.end(), fits))
        throw Error(CLEFT_ERROR_FORMAT, "a label is beyond 32 bits");
    std::transform(wide.begin(), wide.end(), voxels, [](int64_t label) { return static_cast<int32_t>(label); });
}

}  // namespace cleft::mpi
