// An HDF5 file: its bytes, and the headers of its objects. Together with the other hdf5_... files, it reads what
// unstructured grids need, as the "HDF5 File Format Specification, Version 3.0" has it.
#pragma once

#include "io/byte_source.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

// Messages are what a header consists of. Their numbers stand in chapter IV.A.2 of the specification.
struct Hdf5Message {
    uint64_t type;
    std::string bytes;
};

enum : uint64_t {
    kHdf5Dataspace = 0x01,
    kHdf5LinkInfo = 0x02,
    kHdf5Datatype = 0x03,
    kHdf5Link = 0x06,
    kHdf5Layout = 0x08,
    kHdf5Filters = 0x0b,
    kHdf5Attribute = 0x0c,
    kHdf5Continuation = 0x10,
    kHdf5SymbolTable = 0x11
};

class Hdf5File
{
public:
    // Throws Errors that do not name the file, here and below.
    explicit Hdf5File(const std::string& path);

    uint64_t size() const { return size_; }
    // The object at the root of all names.
    uint64_t root() const { return root_; }

    // All of these bytes must be in the file; that is checked before memory is taken.
    std::string bytes(uint64_t address, uint64_t count) const;
    void read(uint64_t address, uint64_t count, void* to) const;
    void check_extent(uint64_t address, uint64_t count) const;

    // What the header of an object has.
    std::vector<Hdf5Message> messages(uint64_t object) const;

    // For each leaf of a tree (B-tree of version 1): body(key, child), in the order of the keys. `type` is 0 for groups
    // and 1 for chunks.
    using LeafVisit = std::function<void(std::string_view key, uint64_t child)>;
    void visit_tree(uint64_t address, uint64_t type, uint64_t key_bytes, const LeafVisit& body) const;

private:
    void read_superblock();

    ByteSource source_;
    uint64_t size_;
    uint64_t root_ = 0;
};

}  // namespace cleft::io
