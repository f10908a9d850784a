// The first bytes of a file, by which its format is known.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

struct FileHead {
    std::vector<unsigned char> bytes;    // as they are, up to 4096
    std::vector<unsigned char> content;  // the same, decompressed where the file is gzip
    uintmax_t size = 0;                  // of the file
    bool gzip = false;
    std::string extension;  // in small letters, ".nii.gz" too

    std::string_view text() const { return {reinterpret_cast<const char*>(content.data()), content.size()}; }
    bool begins_with(std::string_view mark) const { return text().substr(0, mark.size()) == mark; }
};

// Throws Error(CLEFT_ERROR_FILE) for what is no regular file: folders, devices, pipes, and what is not there.
FileHead read_head(const std::string& path);

}  // namespace cleft::io
