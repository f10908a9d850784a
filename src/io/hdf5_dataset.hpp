// The values of a data set of an HDF5 file, with up to two dimensions.
#pragma once

#include "io/hdf5_file.hpp"
#include "io/hdf5_values.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

class Hdf5Dataset
{
public:
    // `name` is for Errors. The file must outlive the data set.
    Hdf5Dataset(const Hdf5File& file, uint64_t object, const std::string& name);

    bool holds_integers() const { return type_.kind == Hdf5Kind::integer; }
    bool holds_numbers() const { return holds_integers() || type_.kind == Hdf5Kind::real; }
    // Rows, and numbers in each: 1 where there is one dimension. A data set without dimensions has one row, one with
    // more than two has no columns.
    uint64_t rows() const { return dims_.empty() ? 1 : dims_[0]; }
    uint64_t columns() const { return dims_.size() < 2 ? 1 : dims_.size() == 2 ? dims_[1] : 0; }

    // All values, row by row. Throws an Error if they are none of these numbers, or have other rows and columns.
    std::vector<double> reals(uint64_t rows, uint64_t columns) const;
    std::vector<int64_t> integers(uint64_t rows, uint64_t columns) const;

private:
    template <class To>
    std::vector<To> read(uint64_t rows, uint64_t columns) const;

    const Hdf5File& file_;
    std::string name_;
    std::vector<Hdf5Message> messages_;
    Hdf5Type type_;
    std::vector<uint64_t> dims_;
};

}  // namespace cleft::io
