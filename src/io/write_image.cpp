// Writes fields of float as volumes: NRRD, MetaImage, legacy VTK; NIfTI has a file of its own. Tensors go to NRRD and
// legacy VTK. What a format cannot hold is refused.
#include "io/write_image.hpp"

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_name.hpp"
#include "io/image_readers.hpp"
#include "io/packed_bytes.hpp"
#include "io/voxel_access.hpp"
#include "io/voxel_data.hpp"
#include "io/write_nifti.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace cleft::io
{

namespace
{

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the headers below say little-endian");

std::string_view voxel_bytes(const Image& image)
{
    return {reinterpret_cast<const char*>(image.voxels.get()), image.bytes()};
}

void print_sizes(AtomicFile& file, const Image& image)
{
    file.print(image.dims[0], ' ', image.dims[1], ' ', image.dims[2], '\n');
}

void print_vector(AtomicFile& file, const Vector3& vector)
{
    file.print('(', vector[0], ',', vector[1], ',', vector[2], ')');
}

void write_nrrd(AtomicFile& file, const Image& image)
{
    // Tensors have an axis of their numbers in front.
    const bool has_tensors = image.fields > 1;
    // Version 4 has the fields of space, version 5 the measurement frame.
    file.print(has_tensors ? "NRRD0005\ntype: float\ndimension: 4\n" : "NRRD0004\ntype: float\ndimension: 3\n",
               "space: left-posterior-superior\nsizes: ", has_tensors ? "6 " : "");
    print_sizes(file, image);
    file.print("space directions:", has_tensors ? " none" : "");
    for (size_t axis = 0; axis < 3; ++axis) {
        file.print(' ');
        print_vector(file, times(image.spacing[axis], image.directions[axis]));
    }
    file.print("\nkinds:", has_tensors ? " 3D-symmetric-matrix" : "",
               " domain domain domain\nendian: little\nencoding: gzip\nspace origin: ");
    print_vector(file, image.origin);
    if (has_tensors)
        file.print("\nmeasurement frame: (1,0,0) (0,1,0) (0,0,1)");
    // The empty line ends the header.
    file.print("\n\n", packed_bytes(voxel_bytes(image), Wrapping::gzip));
}

void write_metaimage(AtomicFile& file, const Image& image)
{
    // First, as CompressedDataSize stands in the header. MetaIO compresses as a zlib stream, not as
    // gzip.
    const std::string voxels = packed_bytes(voxel_bytes(image), Wrapping::zlib);
    file.print("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n",
               "CompressedData = True\nCompressedDataSize = ", voxels.size(), "\nTransformMatrix =");
    for (const Vector3& direction : image.directions)
        for (const double number : direction)
            file.print(' ', number);
    file.print("\nOffset =");
    for (const double number : image.origin)
        file.print(' ', number);
    file.print("\nElementSpacing =");
    for (const double number : image.spacing)
        file.print(' ', number);
    file.print("\nDimSize = ");
    print_sizes(file, image);
    file.print("ElementType = MET_FLOAT\nElementDataFile = LOCAL\n", voxels);
}

// Numbers of legacy VTK are big-endian.
void write_swapped(AtomicFile& file, const std::byte* from, size_t bytes)
{
    std::vector<std::byte> swapped(from, from + bytes);
    swap_bytes(swapped.data(), swapped.size() / sizeof(float), sizeof(float));
    file.write(swapped.data(), swapped.size());
}

void write_vtk_header(AtomicFile& file, const Image& image)
{
    file.print("# vtk DataFile Version 3.0\nCleft sizing field\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS ");
    print_sizes(file, image);
    file.print("ORIGIN ", image.origin[0], ' ', image.origin[1], ' ', image.origin[2], "\nSPACING ", image.spacing[0],
               ' ', image.spacing[1], ' ', image.spacing[2], "\nPOINT_DATA ", image.field_size(), '\n');
}

void write_vtk_volume(AtomicFile& file, const Image& image)
{
    // Copies of 256 kB, so that the field is not held twice.
    constexpr size_t kChunk = size_t{1} << 18;
    write_vtk_header(file, image);
    file.print("SCALARS size float 1\nLOOKUP_TABLE default\n");
    for (size_t begin = 0; begin < image.bytes(); begin += kChunk)
        write_swapped(file, image.voxels.get() + begin, std::min(kChunk, image.bytes() - begin));
    file.print('\n');
}

// All nine numbers of each: programs show TENSORS, and few of them TENSORS6.
void write_vtk_tensors(AtomicFile& file, const Image& image)
{
    constexpr int64_t kAtOnce = 1 << 13;  // tensors
    static constexpr size_t kPlaces[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
    write_vtk_header(file, image);
    file.print("TENSORS metric float\n");
    std::vector<float> nine;
    for (int64_t begin = 0; begin < image.field_size(); begin += kAtOnce) {
        nine.clear();
        for (int64_t v = begin; v < std::min(begin + kAtOnce, image.field_size()); ++v)
            for (const size_t place : kPlaces)
                nine.push_back(load<float>(image.voxels.get(), 6 * v + static_cast<int64_t>(place)));
        write_swapped(file, reinterpret_cast<const std::byte*>(nine.data()), nine.size() * sizeof(float));
    }
    file.print('\n');
}

void check_geometry(const Image& image, const std::string& extension)
{
    // Directions come out of a division and are off by rounding.
    constexpr double kTolerance = 1e-6;
    bool turned = false;
    bool sheared = false;
    for (size_t axis = 0; axis < 3; ++axis) {
        // Structured points have axes along x, y and z only. MetaImage has directions, which ITK
        // wants at right angles.
        turned = turned || image.directions[axis][axis] < 1 - kTolerance;
        sheared = sheared || std::abs(dot(image.directions[axis], image.directions[(axis + 1) % 3])) > kTolerance;
    }
    turned = turned || sheared;
    if ((extension == ".vtk" && turned) || (extension == ".mha" && sheared))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "a " + extension + " file cannot hold a grid that is " +
                                                 (sheared ? "sheared" : "turned") + ": use .nrrd");
}

}  // namespace

void write_image(const std::string& path, const Image& image)
{
    const std::string extension = extension_of(path);
    if (extension == ".nii" || extension == ".nii.gz") {
        write_nifti(path, image);
        return;
    }
    const bool is_nrrd = extension == ".nrrd";
    const bool is_metaimage = extension == ".mha";
    if (!is_nrrd && !is_metaimage && extension != ".vtk")
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "a field can be written as .nrrd, .nii, .nii.gz, .mha or .vtk, not as '" + extension + "'");
    check_geometry(image, extension);
    AtomicFile file(path);
    if (is_nrrd)
        write_nrrd(file, image);
    else if (is_metaimage)
        write_metaimage(file, image);
    else
        write_vtk_volume(file, image);
    file.commit();
}

void write_tensors(const std::string& path, const Image& image)
{
    const std::string extension = extension_of(path);
    const bool is_nrrd = extension == ".nrrd";
    if (!is_nrrd && extension != ".vtk")
        throw Error(CLEFT_ERROR_UNSUPPORTED,
                    "a field with a metric can be written as .nrrd or .vtk, not as '" + extension + "'");
    check_geometry(image, extension);
    AtomicFile file(path);
    if (is_nrrd)
        write_nrrd(file, image);
    else
        write_vtk_tensors(file, image);
    file.commit();
}

}  // namespace cleft::io
