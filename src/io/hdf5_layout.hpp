// Where the values of an HDF5 data set lie in its file: in one piece or in chunks, packed or not.
#pragma once

#include "io/hdf5_file.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

struct Hdf5Chunk {
    std::vector<uint64_t> first;  // its first value along each dimension
    uint64_t address = 0;
    uint64_t bytes = 0;  // in the file
    uint64_t skipped_filters = 0;
};

enum class Hdf5Filter { deflate, shuffle };

// Ranges of bytes were checked against the size of the file.
struct Hdf5Layout {
    bool is_chunked = false;
    std::string compact;  // the values themselves, if the header has them
    uint64_t address = 0, bytes = 0;
    std::vector<uint64_t> chunk_dims;  // of all chunks; those at the end reach beyond the values
    std::vector<Hdf5Chunk> chunks;
    std::vector<Hdf5Filter> filters;  // in the order in which they were applied
};

// Of a data set with these messages, which has values of `value_bytes` bytes. Throws an Error for damage, and for ways
// of keeping values that are not known.
Hdf5Layout hdf5_layout(const Hdf5File& file, const std::vector<Hdf5Message>& messages,
                       const std::vector<uint64_t>& dims, uint64_t value_bytes);

// The values of a chunk, whole.
std::string unpacked_hdf5_chunk(const Hdf5File& file, const Hdf5Layout& layout, const Hdf5Chunk& chunk,
                                uint64_t value_bytes);

}  // namespace cleft::io
