// Reads NIfTI-1, NIfTI-2 and Analyze 7.5: one file, or a header and its voxels in two.
#include "base/counted.hpp"
#include "base/error.hpp"
#include "base/number_text.hpp"
#include "io/byte_source.hpp"
#include "io/image_readers.hpp"
#include "io/nifti_geometry.hpp"
#include "io/nifti_header.hpp"
#include "io/nifti_scaling.hpp"
#include "io/path_kind.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace cleft::io
{

namespace
{

// A file's own name and those of the two that belong together, "a.hdr" and "a.img", each of them perhaps compressed.
struct Names {
    std::string header;
    std::string voxels;
};

bool ends_with(const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// By the bytes and not by the name: programs name compressed files .nii and plain ones .nii.gz.
bool is_gzip(const std::string& path)
{
    ByteSource source(path, Coding::plain);
    unsigned char mark[2] = {};
    return source.read_some(mark, 2) == 2 && mark[0] == 0x1f && mark[1] == 0x8b;
}

Coding coding_of(const std::string& path) { return is_gzip(path) ? Coding::deflated : Coding::plain; }

std::string without_extension(const std::string& path)
{
    const std::string stem = ends_with(path, ".gz") ? path.substr(0, path.size() - 3) : path;
    return stem.substr(0, stem.find_last_of('.'));
}

// The first that is there of STEM.extension, in small and capital letters and compressed.
std::string partner(const std::string& path, const std::string& small, const std::string& capital)
{
    const std::string stem = without_extension(path);
    // The pair may be compressed in one of its files, and comes in capitals from file systems
    // without case.
    for (const std::string& end : {small, small + ".gz", capital, capital + ".GZ"})
        if (is_there(stem + end))
            return stem + end;
    throw Error(CLEFT_ERROR_FILE,
                "there is no file '" + stem.substr(stem.find_last_of('/') + 1) + small + "' beside it");
}

bool is_voxels_of_pair(const std::string& extension) { return extension == ".img" || extension == ".img.gz"; }

NiftiHeader read_nifti_header(const std::string& path)
{
    ByteSource source(path, coding_of(path));
    std::vector<unsigned char> bytes(kNifti2HeaderBytes);
    bytes.resize(source.read_some(bytes.data(), bytes.size()));
    // The name says NIfTI, so a short file is called cut short and not unknown.
    if (bytes.size() < kNifti1HeaderBytes)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + counted(static_cast<int64_t>(bytes.size()), "byte") +
                                            "; a header of NIfTI has " + std::to_string(kNifti1HeaderBytes));
    if (!is_nifti_header(bytes.data(), bytes.size()))
        throw Error(CLEFT_ERROR_FORMAT, "it has no header of NIfTI or Analyze, or it is damaged");
    return parse_nifti_header(bytes.data(), bytes.size());
}

struct NiftiType {
    int code;
    int bits;
    Component component;
};

// DT_ codes of nifti1.h with their bits. Single bits are stored in an order that nifti1.h does not
// define.
constexpr NiftiType kNiftiTypes[] = {
    {2, 8, Component::uint8},      {4, 16, Component::int16},    {8, 32, Component::int32},
    {16, 32, Component::float32},  {64, 64, Component::float64}, {256, 8, Component::int8},
    {512, 16, Component::uint16},  {768, 32, Component::uint32}, {1024, 64, Component::int64},
    {1280, 64, Component::uint64},
};

const char* refused_type(int code)
{
    switch (code) {
        case 1:
            return "single bits";
        case 32:
        case 1792:
        case 2048:
            return "complex numbers";
        case 128:
            return "colours (RGB)";
        case 2304:
            return "colours (RGBA)";
        case 1536:
            return "floating-point numbers of 128 bits";
        default:
            return "of no type of NIfTI";
    }
}

Component component_of(const NiftiHeader& header)
{
    for (const NiftiType& type : kNiftiTypes) {
        if (type.code != header.datatype)
            continue;
        // The two fields must agree. Which of them is wrong cannot be known, and the voxels would
        // be shifted.
        if (type.bits != header.bitpix)
            throw Error(CLEFT_ERROR_FORMAT, "its datatype, " + std::to_string(header.datatype) + ", has " +
                                                std::to_string(type.bits) + " bits, but its bitpix is " +
                                                std::to_string(header.bitpix));
        return type.component;
    }
    throw Error(CLEFT_ERROR_FORMAT, "its voxels are " + std::string(refused_type(header.datatype)) + " (datatype " +
                                        std::to_string(header.datatype) + ")");
}

constexpr int kMatrixIntent = 1004;
constexpr int kSymmetricIntent = 1005;

// What is no volume of numbers, whatever its dimensions are.
// NIFTI_INTENT_ codes of nifti1.h. A vector in three components would pass for three volumes, and
// surface data for a volume of one row.
void check_intent(int intent)
{
    const auto refuse = [&](const char* what) {
        throw Error(CLEFT_ERROR_FORMAT, "it holds " + std::string(what) + " (intent " + std::to_string(intent) +
                                            "), not labels or a function");
    };
    if (intent >= 3000 && intent < 3100)
        refuse("CIFTI data");
    if (intent == 2001)
        refuse("points in time");
    if (intent == 2003 || intent == 2004)
        refuse("colours");
    if (intent == kMatrixIntent || intent == kSymmetricIntent)
        refuse("matrices");
    if (intent == 1006 || intent == 1007 || intent == 1010)
        refuse("vectors");
    if (intent == 1008 || intent == 1009 || intent == 2002 || intent == 2005)
        refuse("a surface");
}

// Makes those that are not used 1.
void check_dimensions(NiftiHeader& header)
{
    // nifti1.h: dim[0] is 1 to 7. Fields beyond it are undefined; some programs leave 0 there.
    const int64_t axes = header.dim[0];
    if (axes < 1 || axes > 7)
        throw Error(CLEFT_ERROR_FORMAT, "its number of dimensions, dim[0], is " + std::to_string(axes));
    for (size_t axis = 1; axis < 8; ++axis) {
        if (static_cast<int64_t>(axis) > axes)
            header.dim[axis] = 1;
        if (header.dim[axis] < 1)
            throw Error(CLEFT_ERROR_FORMAT, "dim[" + std::to_string(axis) + "] is " + std::to_string(header.dim[axis]) +
                                                ": it has no voxels");
    }
}

void check_one_number(const NiftiHeader& header)
{
    // nifti1.h keeps the fifth dimension for several values at each voxel.
    if (header.dim[5] > 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(header.dim[5]) +
                                            " numbers a voxel (its fifth dimension); one is wanted");
    if (header.dim[6] > 1 || header.dim[7] > 1)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has " + std::to_string(header.dim[0]) + " dimensions; at most four are wanted");
}

uintmax_t offset_of_voxels(const NiftiHeader& header)
{
    // nifti1.h requires 352 bytes at least before the voxels of a single file. In a pair they may
    // begin at 0.
    const double least = header.single_file ? static_cast<double>(header.bytes() + kNiftiExtensionMark) : 0;
    const double offset = header.vox_offset;
    // NIfTI-1 stores the offset as a float, which may be NaN. 2^53 is the last whole number that a
    // double counts by ones.
    if (!(offset >= least) || offset != std::floor(offset) || offset > 0x1p53)
        throw Error(CLEFT_ERROR_FORMAT,
                    "its vox_offset is " + number_text(offset) + "; " + number_text(least) + " or more is wanted");
    return static_cast<uintmax_t>(offset);
}

int32_t number_at(const unsigned char* at, bool swapped)
{
    unsigned char raw[4];
    std::memcpy(raw, at, sizeof raw);
    if (swapped)
        std::reverse(raw, raw + 4);
    int32_t value = 0;
    std::memcpy(&value, raw, sizeof value);
    return value;
}

// From behind the header to the voxels; extensions on the way are passed over by the sizes they tell.
void skip_extensions(ByteSource& source, const NiftiHeader& header, uintmax_t offset)
{
    // esize and ecode, four bytes each.
    constexpr size_t kSizeAndCode = 8;
    unsigned char mark[kNiftiExtensionMark];
    source.read(mark, sizeof mark);
    uintmax_t left = offset - header.bytes() - sizeof mark;
    // Each extension begins with its size (esize, a multiple of 16) and its code. Sizes are
    // followed so that a wrong vox_offset shows.
    while (mark[0] != 0 && left >= kSizeAndCode) {
        unsigned char head[kSizeAndCode];
        source.read(head, sizeof head);
        left -= kSizeAndCode;
        const int64_t size = number_at(head, header.swapped);
        if (size < static_cast<int64_t>(kSizeAndCode))  // filled up with zeros
            break;
        if (static_cast<uintmax_t>(size) - kSizeAndCode > left)
            throw Error(CLEFT_ERROR_FORMAT,
                        "an extension of its header, of " + std::to_string(size) + " bytes, runs into its voxels");
        source.skip(static_cast<uintmax_t>(size) - kSizeAndCode);
        left -= static_cast<uintmax_t>(size) - kSizeAndCode;
    }
    source.skip(left);
}

ByteSource source_of_voxels(const std::string& path, const NiftiHeader& header)
{
    const uintmax_t offset = offset_of_voxels(header);
    ByteSource source(path, coding_of(path));
    if (header.single_file) {
        source.skip(header.bytes());
        skip_extensions(source, header, offset);
    } else {
        source.skip(offset);
    }
    return source;
}

void read_voxels(const std::string& path, const NiftiHeader& header, Image& image)
{
    ByteSource source = source_of_voxels(path, header);
    // Before memory is taken for what the header claims.
    source.expect(checked_bytes(image));
    allocate_voxels(image);
    source.read(image.voxels.get(), image.bytes());
    check_end(source, image.bytes(), image);
    if (header.swapped)
        swap_bytes(image);
}

// SPM keeps the place of Analyze's voxels in a file of Matlab's.
// The matrix in it may differ from the header's. Reading MATLAB's format for it is not worth the
// code, so it is reported.
void note_spm_file(const std::string& path, Image& image)
{
    const std::string name = without_extension(path) + ".mat";
    if (is_there(name))
        image.notes.push_back("the place of its voxels in '" + name.substr(name.find_last_of('/') + 1) +
                              "' beside it is not read");
}

Names names_of(const std::string& path, const FileHead& head)
{
    // Users give either file of a pair.
    if (is_voxels_of_pair(head.extension))
        return {partner(path, ".hdr", ".HDR"), path};
    return {path, path};
}

struct NiftiFile {
    Names names;
    NiftiHeader header;
};

NiftiFile open_nifti(const std::string& path, const FileHead& head)
{
    NiftiFile file{names_of(path, head), {}};
    Names& names = file.names;
    file.header = read_nifti_header(names.header);
    if (file.header.single_file)
        // "n+1" in a file called .img is a single file with a wrong name.
        names.voxels = names.header;
    else if (names.voxels == names.header)
        names.voxels = partner(path, ".img", ".IMG");
    return file;
}

// All but the voxels.
Image describe_fields(const std::string& path, const NiftiFile& file, int64_t fields)
{
    const NiftiHeader& header = file.header;
    Image image;
    image.dims = {header.dim[1], header.dim[2], header.dim[3]};
    image.fields = fields;
    image.component = component_of(header);
    set_nifti_geometry(header, image);
    if (header.kind == NiftiKind::analyze)
        note_spm_file(path, image);
    return image;
}

Image read_fields(const std::string& path, const NiftiFile& file, int64_t fields)
{
    const NiftiHeader& header = file.header;
    const std::string& voxels = file.names.voxels;
    Image image = describe_fields(path, file, fields);
    // An error in the other file must name it, as the user did not.
    if (voxels == path)
        read_voxels(path, header, image);
    else
        naming_file(voxels, [&] { read_voxels(voxels, header, image); });
    scale_values(header.slope, header.intercept, image);
    return image;
}

NiftiFile open_nifti_volume(const std::string& path, const FileHead& head)
{
    NiftiFile file = open_nifti(path, head);
    check_intent(file.header.intent);
    check_dimensions(file.header);
    check_one_number(file.header);
    return file;
}

}  // namespace

bool is_nifti(const FileHead& head)
{
    return head.extension == ".nii" || head.extension == ".nii.gz" || is_voxels_of_pair(head.extension) ||
           is_nifti_header(head.content.data(), head.content.size());
}

Image read_nifti(const std::string& path, const FileHead& head)
{
    const NiftiFile file = open_nifti_volume(path, head);
    return read_fields(path, file, file.header.dim[4]);
}

StoredImage locate_nifti(const std::string& path, const FileHead& head)
{
    const NiftiFile file = open_nifti_volume(path, head);
    const std::string& voxels = file.names.voxels;
    // A scaled value is a label only if all of them are whole, which one part does not show.
    if (is_scaled(file.header.slope, file.header.intercept))
        throw Error(CLEFT_ERROR_UNSUPPORTED,
                    "its values are scaled (scl_slope, scl_inter): write them as whole "
                    "numbers without a scale to read them by parts");
    StoredImage stored;
    stored.image = describe_fields(path, file, file.header.dim[4]);
    stored.data.big_endian = file.header.swapped == is_swapped(true);
    stored.data.attached = voxels == path;
    stored.data.files = {voxels};
    stored.data.offset = static_cast<int64_t>(offset_of_voxels(file.header));
    if (is_gzip(voxels))
        stored.data.encoding = VoxelData::Encoding::deflated;
    else
        source_of_voxels(voxels, file.header);  // which checks the extensions on the way
    return stored;
}

TensorImage read_nifti_tensors(const std::string& path, const FileHead& head)
{
    NiftiFile file = open_nifti(path, head);
    NiftiHeader& header = file.header;
    if (header.intent != kMatrixIntent && header.intent != kSymmetricIntent)
        check_intent(header.intent);
    check_dimensions(header);
    // nifti1.h keeps the fifth dimension for the numbers of a voxel. Some programs use the fourth.
    if (header.dim[4] > 1 && header.dim[5] > 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(header.dim[4]) +
                                            " tensors a voxel (its fourth dimension); one is wanted");
    if (header.dim[6] > 1 || header.dim[7] > 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(header.dim[0]) + " dimensions; five are wanted");
    TensorImage tensors;
    tensors.image = read_fields(path, file, header.dim[4] * header.dim[5]);
    // By rows of the lower triangle.
    tensors.order = header.intent == kSymmetricIntent ? CLEFT_IO_ORDER_NIFTI : CLEFT_IO_ORDER_FILE;
    tensors.frame = kRasFrame;
    return tensors;
}

}  // namespace cleft::io
