// Formats of volumes that are not read, but known: each is called by its name, with a way to turn it into one that is.
#include "base/error.hpp"
#include "io/file_name.hpp"
#include "io/image_readers.hpp"

#include <algorithm>
#include <string_view>

namespace cleft::io
{

namespace
{

using namespace std::string_view_literals;

struct Foreign {
    std::string_view mark;        // of the first bytes, decompressed; "" if the extension must do
    std::string_view extensions;  // each followed by a blank; "": any
    const char* name;
    const char* way;  // FILE and STEM stand for the name of the file, with and without its extension
};

constexpr const char* kByNibabel = "in Python, nibabel.save(nibabel.load('FILE'), 'STEM.nii.gz') converts it";
constexpr const char* kByNumpy =
    "save it by nibabel or pynrrd as .nii.gz or .nrrd, or write its array by tofile() and give the file with --dims";
constexpr const char* kByH5py =
    "read its array by h5py and save it as .nii.gz or .nrrd, or write it by tofile() and give the file with --dims";
constexpr const char* kByParaview = "in ParaView, save its data as .vtk (legacy)";
constexpr const char* kByFiji = "in Fiji (Bio-Formats), save the label image as .tif";
constexpr const char* kByPng = "save its slices as .png or .tif";
constexpr const char* kByCheck = "'cleft check FILE' reads it";
constexpr const char* kByMpi = "have cleft-mpi write .vtkhdf or .pvtu as well, which 'cleft' reads";
constexpr const char* kByUnzip = "decompress it first";

constexpr std::string_view kMfemMark = "MFEM mesh";
constexpr const char* kMfem = "a mesh of MFEM";

// The first row that fits is taken, so a row with a mark and an extension stands before one with
// the mark alone. Several formats share the marks of HDF5 (format signature), ZIP and NetCDF.
constexpr Foreign kForeignFormats[] = {
    {"\0\0\0\1"sv, ".mgz .mgh .mgh.gz ", "a volume of FreeSurfer (MGH)",
     "'mri_convert FILE STEM.nii.gz' converts it, or in Python nibabel.save(nibabel.load('FILE'), 'STEM.nii.gz')"},
    {"\x93NUMPY"sv, "", "an array of NumPy", kByNumpy},
    {"PK\3\4"sv, ".npz ", "an archive of NumPy", kByNumpy},
    {"PK\3\4"sv, "", "a ZIP archive", kByUnzip},
    {"\x89HDF\r\n\x1a\n"sv, ".mnc ", "a volume in MINC 2 (HDF5)", kByNibabel},
    {"\x89HDF\r\n\x1a\n"sv, ".ims ", "a file of Imaris (HDF5)", kByFiji},
    {"\x89HDF\r\n\x1a\n"sv, ".vtkhdf ", "a mesh of VTK (VTKHDF) and no volume", kByCheck},
    {"\x89HDF\r\n\x1a\n"sv, "", "an HDF5 file", kByH5py},
    {"CDF\1"sv, ".mnc ", "a volume in MINC 1 (NetCDF)", kByNibabel},
    {"CDF\2"sv, ".mnc ", "a volume in MINC 1 (NetCDF)", kByNibabel},
    {"CDF"sv, ".nc ", "a NetCDF file", kByNumpy},
    {"MATLAB "sv, "", "a file of MATLAB",
     "in MATLAB, niftiwrite(labels, 'STEM.nii') writes its array, or scipy.io.loadmat reads it in Python"},
    {"\xda\xce\xbe\x0a"sv, "", "a file of Nikon (ND2)", kByFiji},
    {"ZISRAWFILE"sv, "", "a file of Zeiss (CZI)", kByFiji},
    {"\x70\0\0\0"sv, ".lif ", "a file of Leica (LIF)", kByFiji},
    {"# AmiraMesh"sv, "", "a file of Amira (AmiraMesh)", "in Amira or Avizo, export it as .nrrd, or in Fiji as .tif"},
    {"# Avizo"sv, "", "a file of Avizo (AmiraMesh)", "in Amira or Avizo, export it as .nrrd, or in Fiji as .tif"},
    {"#INRIMAGE-4#{"sv, "", "a volume in INRIMAGE format", "its voxels begin at byte 256: give --dims and --skip 256"},
    {"BZh"sv, "", "compressed by bzip2", kByUnzip},
    {"\xfd"
     "7zXZ"sv,
     "", "compressed by xz", kByUnzip},
    {"\x28\xb5\x2f\xfd"sv, "", "compressed by Zstandard", kByUnzip},
    {"7z\xbc\xaf\x27\x1c"sv, "", "a 7-Zip archive", kByUnzip},
    {"SIMPLE  ="sv, "", "a FITS file", kByNumpy},
    {""sv, ".npy .npz ", "an array of NumPy by its name, but it is damaged", kByNumpy},
    {"GIF8"sv, "", "a GIF picture", kByPng},
    {"RIFF"sv, ".webp ", "a WebP picture", kByPng},
    {"\0\0\0\x0cjP  "sv, "", "a JPEG 2000 picture", kByPng},
    {"P2"sv, ".pgm ", "a PGM picture", kByPng},
    {"P5"sv, ".pgm ", "a PGM picture", kByPng},
    {"P4"sv, ".pbm ", "a PBM picture", kByPng},
    {"MATRIX7"sv, "", "a volume in ECAT format", kByNibabel},
    {"# === DATA DESCRIPTION FILE"sv, "", "a volume in PAR/REC format", "'parrec2nii FILE' (of nibabel) converts it"},
    {"$MeshFormat"sv, "", "a mesh of Gmsh and no volume", kByCheck},
    {"MeshVersionFormatted"sv, "", "a mesh of MEDIT and no volume", kByCheck},
    {kMfemMark, "", kMfem, kByMpi},
    {"solid"sv, ".stl ", "a surface and no volume", "make a label map of it first"},
    {"ply"sv, ".ply ", "a surface and no volume", "make a label map of it first"},
    {"version https://git-lfs"sv, "", "a pointer of Git LFS and not the file itself",
     "fetch the file by 'git lfs pull'"},
    {"<!DOCTYPE"sv, "", "a web page", "fetch the file itself"},
    {"<html"sv, "", "a web page", "fetch the file itself"},
    {""sv, ".raw .bin .dat .vol ", "a file of voxels without a header, by its name",
     "give their number by --dims and their type by --type"},
};

constexpr std::string_view kXmlImages[] = {"ImageData", "PImageData", "RectilinearGrid", "StructuredGrid"};

// "x.nii.gz " is in the list if each of its items has a blank behind it.
bool is_listed(std::string_view list, const std::string& extension)
{
    return !extension.empty() && list.find(extension + " ") != std::string_view::npos;
}

bool fits(const Foreign& row, const FileHead& head)
{
    return head.begins_with(row.mark) && (row.extensions.empty() || is_listed(row.extensions, head.extension));
}

// An XML declaration and comments may stand before the element, so it is looked for and not
// expected first.
bool is_vtk_xml(const FileHead& head) { return head.text().substr(0, 1000).find("<VTKFile") != std::string_view::npos; }

std::string kind_of_vtk_xml(const FileHead& head)
{
    const std::string_view text = head.text();
    const size_t begin = text.find("type=\"", text.find("<VTKFile"));
    if (begin == std::string_view::npos)
        return "";
    return std::string(text.substr(begin + 6, std::min<size_t>(text.find('"', begin + 6) - begin - 6, 40)));
}

// The name of the user's file is put into the command, so that it can be copied from the message.
// FILE and STEM are replaced in one pass, as the name of the user's file may have these letters in it.
std::string with_names(std::string_view way, const std::string& file)
{
    const std::string stem = file.substr(0, file.size() - extension_of(file).size());
    std::string text;
    while (!way.empty()) {
        const bool is_file = way.substr(0, 4) == "FILE";
        const bool is_stem = way.substr(0, 4) == "STEM";
        text += is_file ? file : is_stem ? stem : std::string(1, way.front());
        way.remove_prefix(is_file || is_stem ? 4 : 1);
    }
    return text;
}

[[noreturn]] void refuse_foreign(const std::string& path, const std::string& name, const std::string& way)
{
    const std::string file = path.substr(path.find_last_of('/') + 1);
    throw Error(CLEFT_ERROR_UNSUPPORTED, "it is " + name + ", which cannot be read: " + with_names(way, file));
}

}  // namespace

bool has_foreign_mark(const FileHead& head)
{
    for (const Foreign& row : kForeignFormats)
        if (!row.mark.empty() && fits(row, head))
            return true;
    return false;
}

bool is_foreign_format(const FileHead& head)
{
    // The extension counts here, too. This question is asked last, after all readers.
    for (const Foreign& row : kForeignFormats)
        if (fits(row, head))
            return true;
    // A gzip file that no reader took is a compressed file of any kind.
    return is_vtk_xml(head) || head.gzip;
}

Image refuse_foreign_format(const std::string& path, const FileHead& head)
{
    for (const Foreign& row : kForeignFormats)
        if (fits(row, head))
            refuse_foreign(path, row.name, row.way);
    if (!is_vtk_xml(head))
        refuse_foreign(path, "compressed by gzip as a whole", "decompress it first, if it is a volume");
    const std::string kind = kind_of_vtk_xml(head);
    for (const std::string_view image : kXmlImages)
        if (kind == image)
            refuse_foreign(path, "VTK XML (" + kind + ")", kByParaview);
    throw Error(CLEFT_ERROR_UNSUPPORTED, "it is VTK XML of kind '" + kind + "', not a volume");
}

void refuse_foreign_mesh(const std::string& path)
{
    FileHead head;
    try {
        head = read_head(path);
    } catch (const Error&) {  // the caller says more of a file that is not there
        return;
    }
    if (head.begins_with(kMfemMark))
        refuse_foreign(path, kMfem, kByMpi);
}

}  // namespace cleft::io
