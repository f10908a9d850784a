// What the values of an HDF5 file are: their type, how many there are, and how they become numbers of ours.
#pragma once

#include "io/hdf5_cursor.hpp"

#include <cstdint>
#include <vector>

namespace cleft::io
{

enum class Hdf5Kind { integer, real, text, other };

struct Hdf5Type {
    Hdf5Kind kind = Hdf5Kind::other;
    uint64_t bytes = 1;  // of one value, at least 1; of a number, at most 8
    bool big_endian = false;
    bool is_signed = false;
};

// From the messages of a header.
Hdf5Type hdf5_type(Hdf5Cursor message);
std::vector<uint64_t> hdf5_dims(Hdf5Cursor message);

// How many values there are. Throws Error(CLEFT_ERROR_FORMAT) where they cannot be counted in 63 bits.
uint64_t hdf5_count(const std::vector<uint64_t>& dims);

// `count` values, which have to be numbers.
void convert_hdf5(const Hdf5Type& type, const char* from, uint64_t count, double* to);
// Integers alone. Unsigned ones beyond 63 bits become negative.
void convert_hdf5(const Hdf5Type& type, const char* from, uint64_t count, int64_t* to);

}  // namespace cleft::io
