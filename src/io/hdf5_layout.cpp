// Chunks are listed by a tree, or there is only one. All must be there, since a value that is missing is no number that
// someone wrote.
#include "io/hdf5_layout.hpp"

#include "base/error.hpp"
#include "io/hdf5_cursor.hpp"
#include "io/hdf5_values.hpp"
#include "io/packed_bytes.hpp"

#include <algorithm>
#include <set>

namespace cleft::io
{

namespace
{

// The numbers of filters that HDF5 comes with.
enum : uint64_t { kDeflateFilter = 1, kShuffleFilter = 2 };

[[noreturn]] void refuse_layout(const std::string& what)
{
    throw Error(CLEFT_ERROR_UNSUPPORTED, "its data sets are " + what + ", which cannot be read");
}

uint64_t bytes_of(std::vector<uint64_t> dims, uint64_t value_bytes)
{
    dims.push_back(value_bytes);
    return hdf5_count(dims);
}

// How many chunks the values need.
uint64_t expected_chunks(const std::vector<uint64_t>& dims, const std::vector<uint64_t>& chunk_dims)
{
    std::vector<uint64_t> along;
    for (size_t i = 0; i < dims.size(); ++i)
        along.push_back(dims[i] / chunk_dims[i] + (dims[i] % chunk_dims[i] > 0));
    return hdf5_count(along);
}

void add_tree_chunks(const Hdf5File& file, uint64_t tree, size_t rank, Hdf5Layout& layout)
{
    if (tree == kNoHdf5Address)
        return;
    // The key of a chunk: its bytes, its filters, and where it begins along each dimension and within a value.
    file.visit_tree(tree, 1, 8 + 8 * (rank + 1), [&](std::string_view key, uint64_t address) {
        Hdf5Cursor at(key);
        Hdf5Chunk chunk;
        chunk.address = address;
        chunk.bytes = at.number(4);
        chunk.skipped_filters = at.number(4);
        for (size_t i = 0; i < rank; ++i)
            chunk.first.push_back(at.number(8));
        layout.chunks.push_back(std::move(chunk));
    });
}

void check_chunks(const Hdf5File& file, const std::vector<uint64_t>& dims, uint64_t value_bytes,
                  const Hdf5Layout& layout)
{
    const uint64_t whole = bytes_of(layout.chunk_dims, value_bytes);
    std::set<std::vector<uint64_t>> places;
    uint64_t all_bytes = 0;
    for (const Hdf5Chunk& chunk : layout.chunks) {
        file.check_extent(chunk.address, chunk.bytes);
        all_bytes += chunk.bytes;
        // Chunks that lie on each other would unpack to more than the file can hold.
        if (all_bytes > file.size() || whole / kGreatestDeflateRatio > chunk.bytes ||
            !places.insert(chunk.first).second)
            Hdf5Cursor::damaged();
        for (size_t i = 0; i < dims.size(); ++i)
            if (chunk.first[i] >= dims[i] || chunk.first[i] % layout.chunk_dims[i] != 0)
                Hdf5Cursor::damaged();
    }
    if (layout.chunks.size() != expected_chunks(dims, layout.chunk_dims))
        throw Error(CLEFT_ERROR_FORMAT, "a data set has no values in some of its chunks");
}

void read_chunk_dims(Hdf5Cursor& at, uint64_t width, size_t rank, uint64_t value_bytes, Hdf5Layout& layout)
{
    if (width == 0 || width > 8)
        Hdf5Cursor::damaged();
    for (size_t i = 0; i < rank; ++i)
        layout.chunk_dims.push_back(at.number(width));
    const auto is_none = [](uint64_t dim) { return dim == 0; };
    if (at.number(width) != value_bytes || std::any_of(layout.chunk_dims.begin(), layout.chunk_dims.end(), is_none))
        Hdf5Cursor::damaged();
}

// Of version 4: only the form for a single chunk.
void read_single_chunk(Hdf5Cursor at, size_t rank, uint64_t value_bytes, Hdf5Layout& layout)
{
    constexpr uint64_t kSingle = 1, kIsFiltered = 0x02;
    const uint64_t flags = at.byte();
    if (at.byte() != rank + 1)
        Hdf5Cursor::damaged();
    const uint64_t width = at.byte();
    read_chunk_dims(at, width, rank, value_bytes, layout);
    if (at.byte() != kSingle)
        refuse_layout("in several chunks in the newest form of HDF5");
    Hdf5Chunk chunk;
    chunk.first.assign(rank, 0);
    chunk.bytes = flags & kIsFiltered ? at.number(8) : bytes_of(layout.chunk_dims, value_bytes);
    chunk.skipped_filters = flags & kIsFiltered ? at.number(4) : 0;
    chunk.address = at.address();
    if (chunk.address != kNoHdf5Address)
        layout.chunks.push_back(std::move(chunk));
}

void read_layout(const Hdf5File& file, Hdf5Cursor at, size_t rank, uint64_t value_bytes, Hdf5Layout& layout)
{
    const uint64_t version = at.version(3, 4, "a layout");
    const uint64_t kind = at.byte();
    if (kind == 0) {
        const uint64_t bytes = at.number(2);
        layout.compact = at.take(bytes);
    } else if (kind == 1) {
        layout.address = at.address();
        layout.bytes = at.number(8);
    } else if (kind == 2) {
        layout.is_chunked = true;
        if (version == 4)
            return read_single_chunk(at, rank, value_bytes, layout);
        if (at.byte() != rank + 1)
            Hdf5Cursor::damaged();
        const uint64_t tree = at.address();
        read_chunk_dims(at, 4, rank, value_bytes, layout);
        add_tree_chunks(file, tree, rank, layout);
    } else {
        refuse_layout("made of others");
    }
}

void read_filters(Hdf5Cursor at, Hdf5Layout& layout)
{
    const bool is_old = at.version(1, 2, "filters") == 1;
    const uint64_t count = at.byte();
    at.skip(is_old ? 6 : 0);
    for (uint64_t i = 0; i < count; ++i) {
        const uint64_t number = at.number(2);
        const bool has_name = is_old || number >= 256;
        const uint64_t name_bytes = has_name ? at.number(2) : 0;
        at.skip(2);
        const uint64_t values = at.number(2);
        at.skip((is_old ? (name_bytes + 7) / 8 * 8 : name_bytes) + 4 * (values + (is_old ? values % 2 : 0)));
        if (number != kDeflateFilter && number != kShuffleFilter)
            refuse_layout("packed by filter " + std::to_string(number) + " of HDF5");
        layout.filters.push_back(number == kDeflateFilter ? Hdf5Filter::deflate : Hdf5Filter::shuffle);
    }
}

// The bytes of all values were sorted: first bytes first, then second ones, and so on.
std::string unshuffled(const std::string& bytes, uint64_t value_bytes)
{
    const size_t values = bytes.size() / value_bytes;
    std::string sorted = bytes;
    for (size_t b = 0; b < value_bytes; ++b)
        for (size_t v = 0; v < values; ++v)
            sorted[v * value_bytes + b] = bytes[b * values + v];
    return sorted;
}

}  // namespace

Hdf5Layout hdf5_layout(const Hdf5File& file, const std::vector<Hdf5Message>& messages,
                       const std::vector<uint64_t>& dims, uint64_t value_bytes)
{
    Hdf5Layout layout;
    const uint64_t bytes = bytes_of(dims, value_bytes);
    bool is_known = false;
    for (const Hdf5Message& message : messages) {
        if (message.type == kHdf5Filters)
            read_filters(Hdf5Cursor(message.bytes), layout);
        if (message.type == kHdf5Layout && !is_known)
            read_layout(file, Hdf5Cursor(message.bytes), dims.size(), value_bytes, layout);
        is_known = is_known || message.type == kHdf5Layout;
    }
    if (layout.is_chunked)
        check_chunks(file, dims, value_bytes, layout);
    else if (layout.compact.empty() && bytes > 0) {
        if (layout.address == kNoHdf5Address || layout.bytes != bytes)
            throw Error(CLEFT_ERROR_FORMAT, "a data set has no values");
        file.check_extent(layout.address, bytes);
    }
    if (!is_known || (!layout.compact.empty() && layout.compact.size() != bytes))
        Hdf5Cursor::damaged();
    return layout;
}

std::string unpacked_hdf5_chunk(const Hdf5File& file, const Hdf5Layout& layout, const Hdf5Chunk& chunk,
                                uint64_t value_bytes)
{
    const uint64_t whole = bytes_of(layout.chunk_dims, value_bytes);
    std::string bytes = file.bytes(chunk.address, chunk.bytes);
    for (size_t i = layout.filters.size(); i-- > 0;) {
        if (chunk.skipped_filters >> i & 1)
            continue;
        if (layout.filters[i] == Hdf5Filter::shuffle) {
            bytes = unshuffled(bytes, value_bytes);
            continue;
        }
        std::string unpacked(whole, '\0');
        if (!unpack_zlib(bytes, unpacked.data(), whole))
            throw Error(CLEFT_ERROR_FORMAT, "a chunk of a data set cannot be inflated");
        bytes = std::move(unpacked);
    }
    if (bytes.size() != whole)
        Hdf5Cursor::damaged();
    return bytes;
}

}  // namespace cleft::io
