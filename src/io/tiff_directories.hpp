// The chain of directories of a TIFF file, walked and bounded before libtiff sees the file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

struct TiffEntry {
    uint16_t tag = 0;
    uint64_t count = 0;
    uint64_t value = 0;  // the number, if it is one whole number of the entry; else where the data lie
};

struct TiffDirectory {
    std::vector<TiffEntry> entries;

    bool has(uint16_t tag) const;
    // The whole number of a tag, or `otherwise` where there is no such tag.
    uint64_t value(uint16_t tag, uint64_t otherwise) const;
    uint64_t count(uint16_t tag) const;
    // A smaller copy of another page, or a mask of one: no slice.
    bool is_thumbnail() const;
    bool is_mask() const;
};

struct TiffDirectories {
    std::vector<TiffDirectory> list;
    uint64_t file_bytes = 0;
    bool big_endian = false;
};

// Errors do not name the file.
// Throws Error(CLEFT_ERROR_FORMAT) for a chain or a tag that goes beyond the file, and for circles.
TiffDirectories tiff_directories(const std::string& path);

}  // namespace cleft::io
