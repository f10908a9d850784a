// Reads windows of voxels at their places in the file. Files whose voxels have no such places are refused.
#include "io/voxel_file.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/file_name.hpp"
#include "io/text_scanner.hpp"
#include "io/voxels.hpp"

#include <algorithm>
#include <cstring>

namespace cleft::io
{

namespace
{

// As many voxels are converted at a time: they stay in the cache.
constexpr int64_t kConvertedVoxels = int64_t{1} << 15;

[[noreturn]] void refuse_parts(const std::string& path, const std::string& what)
{
    throw Error(CLEFT_ERROR_UNSUPPORTED, what + ", and cannot be read by parts: " + way_to_parts(path));
}

// The file with the voxels.
std::string checked_file(const std::string& path, const StoredImage& stored)
{
    return naming_file(path, [&] {
        const auto files = static_cast<int64_t>(stored.data.files.size());
        if (stored.data.encoding == VoxelData::Encoding::deflated)
            refuse_parts(path, "its voxels are compressed");
        if (stored.data.encoding != VoxelData::Encoding::raw)
            refuse_parts(path, "its voxels are text");
        if (files != 1)
            refuse_parts(path, "its voxels are in " + counted(files, "file"));
        if (stored.image.fields != 1)
            throw Error(CLEFT_ERROR_UNSUPPORTED,
                        "it holds " + counted(stored.image.fields, "volume") +
                            ", but one label map is wanted: write one frame to a file of its own");
        if (is_floating(stored.image.component))
            throw Error(CLEFT_ERROR_UNSUPPORTED,
                        "its voxels are floating-point numbers, but a label map that is read "
                        "by parts must be of whole ones: convert them, in Python by "
                        "SimpleITK.Cast(image, SimpleITK.sitkInt32)");
        return stored.data.files.front();
    });
}

// The place of the first voxel. All of them must be in the file.
uintmax_t checked_begin(const std::string& path, const ByteSource& source, StoredImage& stored)
{
    return naming_file(path, [&] {
        const uintmax_t bytes = checked_bytes(stored.image);
        const uintmax_t size = source.left();
        // Both are below 2^63.
        const uintmax_t begin = begin_of_voxels(stored.data, path, bytes) + static_cast<uintmax_t>(stored.data.skip);
        if (begin > size || bytes > size - begin)
            throw Error(CLEFT_ERROR_FORMAT, "it has " + counted(static_cast<int64_t>(size), "byte") + ", but its " +
                                                std::to_string(bytes) + " bytes of voxels begin at byte " +
                                                std::to_string(begin) + ": it is cut short");
        if (!stored.is_followed)
            judge_surplus(size - begin - bytes, bytes, stored.image);
        return begin;
    });
}

}  // namespace

std::string way_to_parts(const std::string& path)
{
    const std::string file = path.substr(path.find_last_of('/') + 1);
    const std::string stem = file.substr(0, file.size() - extension_of(file).size());
    return "write its voxels uncompressed to one file, in Python by SimpleITK.WriteImage(SimpleITK.ReadImage('" + file +
           "'), '" + stem + "-raw.mha')";
}

VoxelFile::VoxelFile(const std::string& path, StoredImage& stored)
    : path_(checked_file(path, stored)),
      source_(naming_file(path_, [&] { return ByteSource(path_, Coding::plain); })),
      dims_(stored.image.dims),
      component_(stored.image.component),
      swapped_(is_swapped(stored.data.big_endian)),
      begin_(checked_begin(path_, source_, stored))
{
}

Component VoxelFile::label_type() const { return label_component(component_); }

void VoxelFile::check_window(const int64_t first[3], const int64_t count[3]) const
{
    for (size_t axis = 0; axis < 3; ++axis)
        if (first[axis] < 0 || count[axis] < 0 || first[axis] > dims_[axis] || count[axis] > dims_[axis] - first[axis])
            throw Error(CLEFT_ERROR_ARGUMENT,
                        counted(count[axis], "voxel") + " from voxel " + std::to_string(first[axis]) +
                            " on along the " + ordinal(static_cast<int64_t>(axis)) + " axis are asked for of '" +
                            path_ + "', which has " + std::to_string(dims_[axis]) + ", numbered from 0");
}

// Numbers that follow one another in the file, in the order of bytes of this machine.
void VoxelFile::read_numbers(int64_t voxel, int64_t count, std::byte* numbers) const
{
    const size_t size = size_of(component_);
    const uintmax_t offset = begin_ + static_cast<uintmax_t>(voxel) * size;
    try {
        source_.read_at(offset, numbers, static_cast<size_t>(count) * size);
    } catch (const Error& error) {
        // The file has changed since it was opened, or the disk fails.
        throw Error(error.status(), "its voxels from byte " + std::to_string(offset) + " on: " + error.what());
    }
    if (swapped_)
        swap_bytes(numbers, static_cast<size_t>(count), size);
}

void VoxelFile::read_run(int64_t voxel, int64_t count, std::byte* labels) const
{
    if (label_type() == component_) {
        read_numbers(voxel, count, labels);
        return;
    }
    for (int64_t done = 0; done < count; done += kConvertedVoxels) {
        Image piece;
        piece.component = component_;
        piece.dims[0] = std::min(kConvertedVoxels, count - done);
        allocate_voxels(piece);
        read_numbers(voxel + done, piece.dims[0], piece.voxels.get());
        make_labels(piece);
        std::memcpy(labels + static_cast<size_t>(done) * size_of(piece.component), piece.voxels.get(), piece.bytes());
    }
}

void VoxelFile::read(const int64_t first[3], const int64_t count[3], std::byte* labels) const
{
    check_window(first, count);
    if (count[0] == 0 || count[1] == 0 || count[2] == 0)
        return;
    // Whole rows follow one another in the file, and so do whole planes.
    const bool whole_rows = count[0] == dims_[0];
    const bool whole_planes = whole_rows && count[1] == dims_[1];
    const int64_t rows = whole_rows ? 1 : count[1];
    const int64_t planes = whole_planes ? 1 : count[2];
    const int64_t run = count[0] * (count[1] / rows) * (count[2] / planes);
    const size_t step = static_cast<size_t>(run) * size_of(label_type());
    naming_file(path_, [&] {
        for (int64_t z = 0; z < planes; ++z)
            for (int64_t y = 0; y < rows; ++y, labels += step)
                read_run(first[0] + dims_[0] * (first[1] + y + dims_[1] * (first[2] + z)), run, labels);
    });
}

}  // namespace cleft::io
