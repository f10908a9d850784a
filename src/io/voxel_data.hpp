// The voxels of an image where a header says they are: in one file or several, binary or text, compressed or not.
#pragma once

#include "io/byte_source.hpp"
#include "io/image.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

struct VoxelData {
    enum class Encoding { raw, deflated, text, hex };
    Encoding encoding = Encoding::raw;
    bool big_endian = false;
    bool attached = false;  // behind the header: Errors need not name the file
    // Where they begin: `offset` bytes and then `lines` lines into each file, and then `skip` bytes of what is there
    // decompressed. An offset of -1: so that they end with the file.
    int64_t offset = 0;
    int64_t lines = 0;
    int64_t skip = 0;
    uintmax_t length = ByteSource::kToTheEnd;  // of what is compressed
    // One after the other; each holds an equal share of the voxels.
    std::vector<std::string> files;
};

// Fills image.voxels; everything else of the image must be set. What is left over behind the voxels goes to the notes.
// Throws Error: FORMAT where files are too short, too long or damaged, FILE where one is missing.
void read_voxels(const VoxelData& data, Image& image);

// Where the voxels begin in a file, before `skip`. Raw data have `bytes` bytes in the file.
uintmax_t begin_of_voxels(const VoxelData& data, const std::string& path, uintmax_t bytes);

// So many bytes stand behind `wanted` bytes of voxels. A little more is passed over with a note; as much again means
// that the header is wrong.
void judge_surplus(uintmax_t surplus, uintmax_t wanted, Image& image);

// For a source of which `wanted` bytes of voxels were read. What is left is judged as above. The check sum of what is
// compressed must be right.
void check_end(ByteSource& source, uintmax_t wanted, Image& image);

// Of a text that ends with a number, nobody knows whether it had more digits.
void note_text_end(bool within_number, Image& image);

// Numbers of text, separated by blanks or commas, into `count` voxels from `first` on; gives what is left of the text.
std::string_view read_text_voxels(std::string_view text, Image& image, int64_t first, int64_t count);

// One number of text into a voxel.
void store_text_voxel(std::string_view word, Image& image, int64_t voxel);

// Is it not the order of this machine?
bool is_swapped(bool big_endian);
// From big-endian to the order of this machine, or back.
void swap_bytes(std::byte* values, size_t count, size_t size);
// Of all voxels.
void swap_bytes(Image& image);

// The file that a header names, beside the header unless the name is absolute.
std::string beside(const std::string& header, const std::string& name);

}  // namespace cleft::io
