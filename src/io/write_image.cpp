// Writes fields of float as volumes: NRRD, MetaImage, legacy VTK; NIfTI has a file of its own. What a format cannot
// hold is refused.
#include "io/write_image.hpp"

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_name.hpp"
#include "io/image_readers.hpp"
#include "io/packed_bytes.hpp"
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
    // Version 4 has the fields of space; versions above add nothing that is needed here.
    file.print("NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: ");
    print_sizes(file, image);
    file.print("space directions:");
    for (size_t axis = 0; axis < 3; ++axis) {
        file.print(' ');
        print_vector(file, times(image.spacing[axis], image.directions[axis]));
    }
    file.print("\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: ");
    print_vector(file, image.origin);
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

void write_vtk_volume(AtomicFile& file, const Image& image)
{
    // Big-endian copies of 256 kB, so that the field is not held twice.
    constexpr size_t kChunk = size_t{1} << 18;
    file.print("# vtk DataFile Version 3.0\nCleft sizing field\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS ");
    print_sizes(file, image);
    file.print("ORIGIN ", image.origin[0], ' ', image.origin[1], ' ', image.origin[2], "\nSPACING ", image.spacing[0],
               ' ', image.spacing[1], ' ', image.spacing[2], "\nPOINT_DATA ", image.field_size(),
               "\nSCALARS size float 1\nLOOKUP_TABLE default\n");
    std::vector<std::byte> swapped;
    for (size_t begin = 0; begin < image.bytes(); begin += kChunk) {
        const std::byte* from = image.voxels.get() + begin;
        swapped.assign(from, from + std::min(kChunk, image.bytes() - begin));
        swap_bytes(swapped.data(), swapped.size() / sizeof(float), sizeof(float));
        file.write(swapped.data(), swapped.size());
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

}  // namespace cleft::io
