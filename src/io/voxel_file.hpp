// A label map of which any part can be read, while the rest stays in its file.
#pragma once

#include "io/stored_image.hpp"

#include <string>

namespace cleft::io
{

// How users make a file of this one that can be read by parts.
std::string way_to_parts(const std::string& path);

// Holds a descriptor of the file until it is destroyed.
class VoxelFile
{
public:
    // `path` is that of the user. What is found about the file goes to stored.image.notes. Throws Errors that name the
    // file.
    VoxelFile(const std::string& path, StoredImage& stored);

    // The type of the labels that read() gives: one of the five of the core.
    Component label_type() const;
    // Voxels first[i] to first[i] + count[i] - 1 along each axis, x fastest. Throws Errors that name the file.
    void read(const int64_t first[3], const int64_t count[3], std::byte* labels) const;

private:
    void check_window(const int64_t first[3], const int64_t count[3]) const;
    void read_numbers(int64_t voxel, int64_t count, std::byte* numbers) const;
    void read_run(int64_t voxel, int64_t count, std::byte* labels) const;

    std::string path_;  // of the file with the voxels
    ByteSource source_;
    std::array<int64_t, 3> dims_;
    Component component_;
    bool swapped_;
    uintmax_t begin_ = 0;
};

}  // namespace cleft::io
