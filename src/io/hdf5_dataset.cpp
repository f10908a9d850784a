// Values are converted as they are read, so that they are in memory once.
#include "io/hdf5_dataset.hpp"

#include "base/error.hpp"
#include "io/hdf5_layout.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

template <class To>
void read_piece(const Hdf5File& file, const Hdf5Layout& layout, const Hdf5Type& type, std::vector<To>& values)
{
    // Some megabytes at once.
    constexpr uint64_t kValuesAtOnce = uint64_t{1} << 20;
    for (uint64_t first = 0; first < values.size(); first += kValuesAtOnce) {
        const uint64_t count = std::min<uint64_t>(kValuesAtOnce, values.size() - first);
        const std::string bytes = layout.compact.empty()
                                      ? file.bytes(layout.address + first * type.bytes, count * type.bytes)
                                      : layout.compact.substr(first * type.bytes, count * type.bytes);
        convert_hdf5(type, bytes.data(), count, values.data() + first);
    }
}

// One dimension counts as one column.
template <class To>
void read_chunks(const Hdf5File& file, const Hdf5Layout& layout, const Hdf5Type& type, uint64_t rows, uint64_t columns,
                 std::vector<To>& values)
{
    const uint64_t chunk_rows = layout.chunk_dims.empty() ? 1 : layout.chunk_dims[0];
    const uint64_t chunk_columns = layout.chunk_dims.size() < 2 ? 1 : layout.chunk_dims[1];
    for (const Hdf5Chunk& chunk : layout.chunks) {
        const std::string bytes = unpacked_hdf5_chunk(file, layout, chunk, type.bytes);
        const uint64_t first_row = chunk.first.empty() ? 0 : chunk.first[0];
        const uint64_t first_column = chunk.first.size() < 2 ? 0 : chunk.first[1];
        const uint64_t width = std::min(chunk_columns, columns - first_column);
        for (uint64_t row = 0; row < std::min(chunk_rows, rows - first_row); ++row)
            convert_hdf5(type, bytes.data() + row * chunk_columns * type.bytes, width,
                         values.data() + (first_row + row) * columns + first_column);
    }
}

}  // namespace

Hdf5Dataset::Hdf5Dataset(const Hdf5File& file, uint64_t object, const std::string& name)
    : file_(file), name_(name), messages_(file.messages(object))
{
    bool has_type = false, has_dims = false;
    for (const Hdf5Message& message : messages_) {
        if (message.type == kHdf5Datatype) {
            type_ = hdf5_type(Hdf5Cursor(message.bytes));
            has_type = true;
        } else if (message.type == kHdf5Dataspace) {
            dims_ = hdf5_dims(Hdf5Cursor(message.bytes));
            has_dims = true;
        }
    }
    if (!has_type || !has_dims)
        throw Error(CLEFT_ERROR_FORMAT, "'" + name_ + "' is no data set");
}

template <class To>
std::vector<To> Hdf5Dataset::read(uint64_t rows, uint64_t columns) const
{
    // A wrong length would shift the labels of all cells.
    if (this->rows() != rows || this->columns() != columns)
        throw Error(CLEFT_ERROR_FORMAT, "the data set '" + name_ + "' has " + std::to_string(this->rows()) + " x " +
                                            std::to_string(this->columns()) + " numbers instead of " +
                                            std::to_string(rows) + " x " + std::to_string(columns));
    const Hdf5Layout layout = hdf5_layout(file_, messages_, dims_, type_.bytes);
    std::vector<To> values(rows * columns);
    if (layout.is_chunked)
        read_chunks(file_, layout, type_, rows, columns, values);
    else
        read_piece(file_, layout, type_, values);
    return values;
}

std::vector<double> Hdf5Dataset::reals(uint64_t rows, uint64_t columns) const
{
    if (!holds_numbers())
        throw Error(CLEFT_ERROR_FORMAT, "the data set '" + name_ + "' has no numbers");
    return read<double>(rows, columns);
}

std::vector<int64_t> Hdf5Dataset::integers(uint64_t rows, uint64_t columns) const
{
    if (!holds_integers())
        throw Error(CLEFT_ERROR_FORMAT, "the data set '" + name_ + "' has no whole numbers");
    return read<int64_t>(rows, columns);
}

}  // namespace cleft::io
