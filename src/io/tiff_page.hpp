// What one page of a TIFF file holds, and its voxels.
#pragma once

#include "io/image.hpp"
#include "io/tiff_directories.hpp"
#include "io/tiff_file.hpp"

#include <string>

namespace cleft::io
{

struct TiffPage {
    std::string name;  // "the 3rd page", for messages
    int64_t width = 0;
    int64_t height = 0;
    unsigned bits = 0;
    unsigned compression = 0;
    bool white_is_zero = false;
    bool tiled = false;
    Component component = Component::uint8;

    uint64_t row_bytes() const { return (static_cast<uint64_t>(width) * bits + 7) / 8; }  // in the file, unpacked
    uint64_t voxel_bytes() const
    {
        return static_cast<uint64_t>(width) * static_cast<uint64_t>(height) * size_of(component);
    }
};

// The page that libtiff is at. Throws, naming the page, if it holds anything but one number a voxel of a type and
// compression that can be read, or if its strips or tiles cannot be in the file.
TiffPage tiff_page(const TiffFile& file, const TiffDirectory& directory, uint64_t file_bytes, const std::string& name);

// The most bytes that a byte of the file can become.
double most_expansion(const TiffPage& page);

// Decodes the page that libtiff is at, all of it or throws.
void read_tiff_page(TiffFile& file, const TiffPage& page, std::byte* voxels);

}  // namespace cleft::io
