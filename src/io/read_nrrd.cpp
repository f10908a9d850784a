// NRRD, attached or detached, and the segmentations of 3D Slicer, which are NRRD with keys of their own.
#include "base/error.hpp"
#include "io/header_values.hpp"
#include "io/image_readers.hpp"
#include "io/nrrd_geometry.hpp"
#include "io/segments.hpp"

#include <cstring>

namespace cleft::io
{

namespace
{

// Numbers of several volumes that lie side by side for each voxel are put one volume after the other.
void separate_fields(Image& image)
{
    const size_t size = size_of(image.component);
    const auto fields = static_cast<size_t>(image.fields);
    const auto count = static_cast<size_t>(image.field_size());
    std::unique_ptr<std::byte[]> mixed = std::move(image.voxels);
    allocate_voxels(image);
    for (size_t field = 0; field < fields; ++field)
        for (size_t voxel = 0; voxel < count; ++voxel)
            std::memcpy(&image.voxels[(field * count + voxel) * size], &mixed[(voxel * fields + field) * size], size);
}

StoredImage locate_as_stored(NrrdHeader& header, const NrrdAxes& axes)
{
    StoredImage stored;
    Image& image = stored.image;
    image.notes = std::move(header.notes);
    image.component = header.component;
    for (size_t a = 0; a < axes.space.size(); ++a)
        image.dims[a] = header.sizes[axes.space[a]];
    if (axes.other)
        image.fields = header.sizes[*axes.other];
    set_nrrd_geometry(header, axes, image);
    stored.data = std::move(header.data);
    return stored;
}

Image read_as_stored(NrrdHeader& header, const NrrdAxes& axes)
{
    StoredImage stored = locate_as_stored(header, axes);
    read_voxels(stored.data, stored.image);
    return std::move(stored.image);
}

// By the kind of the axis of the numbers, whose size must fit it.
cleft_io_tensor_order order_of(const NrrdHeader& header, size_t axis)
{
    struct Kind {
        const char* name;  // in small letters
        int64_t size;
        cleft_io_tensor_order order;
    };
    // Of nine numbers there is no question.
    static constexpr Kind kKinds[] = {{"3d-symmetric-matrix", 6, CLEFT_IO_ORDER_NRRD},
                                      {"3d-masked-symmetric-matrix", 7, CLEFT_IO_ORDER_NRRD},
                                      {"3d-matrix", 9, CLEFT_IO_ORDER_FILE}};
    const std::string kind = header.kinds.empty() ? "???" : header.kinds[axis];
    const int64_t size = header.sizes[axis];
    for (const Kind& row : kKinds) {
        if (kind == row.name && size != row.size)
            refuse_field("kinds", kind, "its axis has a size of " + std::to_string(size));
        if (kind == row.name)
            return row.order;
    }
    if (kind == "3d-masked-matrix" || size == 7)
        refuse_field("kinds", kind, "a mask is read of a 3D-masked-symmetric-matrix alone");
    return CLEFT_IO_ORDER_FILE;
}

}  // namespace

// Editors of text put a mark of UTF-8 before hand-written headers.
bool is_nrrd(const FileHead& head)
{
    const std::string_view text = head.text();
    return !head.gzip && text.substr(text.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0, 4) == "NRRD";
}

Image read_nrrd(const std::string& path, const FileHead&)
{
    NrrdHeader header = read_nrrd_header(path);
    const NrrdAxes axes = nrrd_axes(header);
    Image image = read_as_stored(header, axes);
    // An axis of fields in front is the fastest: the numbers of one voxel lie side by side, as
    // Slicer writes layers.
    if (axes.other && *axes.other < axes.space.front())
        separate_fields(image);
    // Last, as layers must be separate fields by then.
    if (has_segments(header.keys))
        apply_segments(header.keys, image);
    return image;
}

StoredImage locate_nrrd(const std::string& path, const FileHead&)
{
    NrrdHeader header = read_nrrd_header(path);
    StoredImage stored = locate_as_stored(header, nrrd_axes(header));
    if (has_segments(header.keys))
        check_segments(header.keys, stored.image);
    return stored;
}

TensorImage read_nrrd_tensors(const std::string& path, const FileHead&)
{
    NrrdHeader header = read_nrrd_header(path);
    const NrrdAxes axes = nrrd_tensor_axes(header);
    TensorImage tensors;
    tensors.order = order_of(header, *axes.other);
    tensors.image = read_as_stored(header, axes);
    tensors.side_by_side = *axes.other == 0;
    tensors.frame = nrrd_measurement_frame(header);
    return tensors;
}

}  // namespace cleft::io
