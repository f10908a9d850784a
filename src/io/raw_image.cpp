// Reads voxels without a header, whose layout the caller gives. Nothing in the file can show a
// mistake but its size, so the size must fit exactly.
#include "io/raw_image.hpp"

#include "base/counted.hpp"
#include "base/struct_size.hpp"
#include "io/meaning.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

// The size of the struct in version 0.1. Callers that were compiled with it stay valid when fields
// are added at the end.
template <>
inline constexpr size_t cleft::kFirstSize<cleft_io_raw> = CLEFT_END_OF(cleft_io_raw, spacing);

namespace cleft::io
{

namespace
{

Component component_of(cleft_type type)
{
    switch (type) {
        case CLEFT_TYPE_UINT8:
            return Component::uint8;
        case CLEFT_TYPE_UINT16:
            return Component::uint16;
        case CLEFT_TYPE_INT16:
            return Component::int16;
        case CLEFT_TYPE_UINT32:
            return Component::uint32;
        case CLEFT_TYPE_INT32:
            return Component::int32;
        case CLEFT_TYPE_FLOAT32:
            return Component::float32;
        case CLEFT_TYPE_FLOAT64:
            return Component::float64;
        default:
            throw Error(CLEFT_ERROR_ARGUMENT, "there is no type of voxels " + std::to_string(type));
    }
}

}  // namespace

cleft_io_raw checked_layout(const cleft_io_raw* raw)
{
    cleft_io_raw layout = copy_in(*raw, "cleft_io_raw");
    // Called for its Error only: a wrong type must be reported before a file is opened.
    component_of(layout.type);
    check_kind(layout.kind);
    if (layout.skip < 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "the number of bytes to skip is negative");
    for (int axis = 0; axis < 3; ++axis)
        if (layout.dims[axis] < 1)
            throw Error(CLEFT_ERROR_ARGUMENT, "there must be at least one voxel along each axis");
    const double* spacing = layout.spacing;
    // All zeros is what a caller leaves who fills the struct with zeros, and means unit cubes.
    if (spacing[0] == 0 && spacing[1] == 0 && spacing[2] == 0)
        std::fill_n(layout.spacing, 3, 1.0);
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(spacing[axis]) || spacing[axis] <= 0)
            throw Error(CLEFT_ERROR_ARGUMENT, "the spacing must be positive along each axis");
    return layout;
}

StoredImage locate_raw_image(const std::string& path, const cleft_io_raw& layout)
{
    StoredImage stored;
    Image& image = stored.image;
    image.component = component_of(layout.type);
    std::copy_n(layout.dims, 3, image.dims.begin());
    std::copy_n(layout.spacing, 3, image.spacing.begin());
    // The corner of the box lies at 0, so the first centre is half a voxel away.
    image.origin = times(0.5, image.spacing);
    std::error_code error;
    const uintmax_t size = std::filesystem::file_size(path, error);
    if (error)
        throw Error(CLEFT_ERROR_FILE, "cannot read '" + path + "': " + error.message());
    const uintmax_t expected =
        // checked_bytes() is below 2^63 and so is skip: the sum fits.
        static_cast<uintmax_t>(layout.skip) + naming_file(path, [&] { return checked_bytes(image); });
    // A file that is longer has a header or other dimensions. Reading its beginning would give a
    // plausible, sheared picture.
    if (size != expected)
        throw Error(CLEFT_ERROR_FORMAT, "'" + path + "' has " + counted(static_cast<int64_t>(size), "byte") +
                                            ", but its voxels" + (layout.skip > 0 ? " and what is skipped" : "") +
                                            " would have " + std::to_string(expected));
    stored.data.big_endian = layout.big_endian != 0;
    stored.data.attached = true;  // the path is that of the voxels
    stored.data.offset = layout.skip;
    stored.data.files = {path};
    return stored;
}

Image read_raw_image(const std::string& path, const cleft_io_raw& layout)
{
    StoredImage stored = locate_raw_image(path, layout);
    naming_file(path, [&] { read_voxels(stored.data, stored.image); });
    return std::move(stored.image);
}

}  // namespace cleft::io
