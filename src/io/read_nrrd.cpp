// NRRD, attached or detached, and the segmentations of 3D Slicer, which are NRRD with keys of their own.
#include "base/error.hpp"
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
    Image image;
    image.notes = std::move(header.notes);
    image.component = header.component;
    for (size_t a = 0; a < axes.space.size(); ++a)
        image.dims[a] = header.sizes[axes.space[a]];
    if (axes.other)
        image.fields = header.sizes[*axes.other];
    set_nrrd_geometry(header, axes, image);
    read_voxels(header.data, image);
    // An axis of fields in front is the fastest: the numbers of one voxel lie side by side, as
    // Slicer writes layers.
    if (axes.other && *axes.other < axes.space.front())
        separate_fields(image);
    // Last, as layers must be separate fields by then.
    if (has_segments(header.keys))
        apply_segments(header.keys, image);
    return image;
}

}  // namespace cleft::io
