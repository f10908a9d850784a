// Label maps in HDF5, read box by box.
#pragma once

#include "cleft/cleft_parts.h"
#include "mpi/hdf5.hpp"

#include <array>
#include <string>

namespace cleft::mpi
{

class Hdf5Voxels
{
public:
    // `dataset` "": the only one that fits. Throws Error.
    Hdf5Voxels(const std::string& path, const std::string& dataset);

    cleft_type type() const { return type_; }
    std::array<int64_t, 3> dims() const { return dims_; }
    // Three numbers, x first. False if the data set has no such attribute.
    bool get_attribute(const char* name, std::array<double, 3>& out) const;

    // As cleft_voxels_read has it. Throws Error.
    void read(const int64_t first[3], const int64_t count[3], void* voxels) const;

    // The path, for sentences.
    const std::string& path() const { return path_; }

private:
    void read_narrowed(hid_t memory, hid_t box, const int64_t count[3], int32_t* voxels) const;

    std::string path_;
    Hdf5Id file_, data_;
    std::array<int64_t, 3> dims_{};
    cleft_type type_ = CLEFT_TYPE_INT32;
    bool is_wide_ = false;  // 64 bits in the file
};

}  // namespace cleft::mpi
