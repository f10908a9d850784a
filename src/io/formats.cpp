// The table of all formats that are read and written, and searches in it. The command's help, the
// bindings and the choice by extension all come from it.
#include "io/formats.hpp"

#include "io/file_name.hpp"

#include <iterator>
#include <sstream>

namespace cleft::io
{

namespace
{

bool has_extension(const cleft_io_format_description& row, const std::string& extension)
{
    std::istringstream list(row.extensions);
    for (std::string item; list >> item;)
        if (item == extension)
            return true;
    return false;
}

constexpr int32_t both = CLEFT_IO_READS_MESH | CLEFT_IO_WRITES_MESH;
constexpr int32_t out = CLEFT_IO_WRITES_MESH;
constexpr int32_t volume = CLEFT_IO_READS_VOLUME;
constexpr int32_t field = CLEFT_IO_READS_VOLUME | CLEFT_IO_WRITES_SIZING;

// A format of volumes has the number 0: it is recognised by its bytes and never chosen by the
// caller.
constexpr cleft_io_format_description row(cleft_io_format format, int32_t directions, const char* name,
                                          const char* extensions, const char* text)
{
    return {sizeof(cleft_io_format_description), format, directions, 0, name, extensions, text};
}

// The order is that of the help. Of two mesh formats with one extension the first is the default:
// .msh is written as 4.1.
constexpr cleft_io_format_description formats[] = {
    row(CLEFT_FORMAT_VTU, both, "vtu", ".vtu", "VTK XML, tetrahedra with their material; binary, compressed"),
    row(CLEFT_FORMAT_VTP, out, "vtp", ".vtp", "VTK XML, interface triangles with their materials; binary, compressed"),
    row(CLEFT_FORMAT_VTK, both, "vtk", ".vtk", "VTK legacy, tetrahedra with their material; text"),
    row(CLEFT_FORMAT_MEDIT, both, "medit", ".mesh", "MEDIT, tetrahedra and surface triangles; text"),
    row(CLEFT_FORMAT_MSH41, both, "msh41", ".msh", "Gmsh 4.1 with physical groups by name; binary"),
    row(CLEFT_FORMAT_MSH22, both, "msh22", ".msh", "Gmsh 2.2 with physical groups by name; text"),
    row(CLEFT_FORMAT_ABAQUS, out, "abaqus", ".inp", "Abaqus and CalculiX, ELSET, SURFACE and NSET; text"),
    row(CLEFT_FORMAT_TETGEN, both, "tetgen", ".node .ele .face", "TetGen, three files; text"),
    row(CLEFT_FORMAT_STL, out, "stl", ".stl", "STL of the interface triangles; binary, single precision"),
    row(CLEFT_FORMAT_PLY, out, "ply", ".ply", "PLY of the interface triangles with their materials; binary"),
    row(0, field, "nrrd", ".nrrd", "NRRD"),
    row(0, volume, "nhdr", ".nhdr", "NRRD with the voxels in a file of their own"),
    row(0, field, "nifti", ".nii .nii.gz", "NIfTI"),
    row(0, volume, "analyze", ".hdr .img .img.gz", "NIfTI or Analyze 7.5 in two files"),
    row(0, field, "metaimage", ".mha", "MetaImage"),
    row(0, volume, "mhd", ".mhd", "MetaImage with the voxels in a file of their own"),
    row(0, volume, "tiff", ".tif .tiff", "TIFF stack, or a series of slices"),
    row(0, volume, "png", ".png", "PNG, a series of slices"),
    row(0, volume, "jpeg", ".jpg .jpeg", "JPEG, a series of slices"),
    row(0, volume, "bmp", ".bmp", "BMP, a series of slices"),
    row(0, volume, "dicom", ".dcm", "DICOM, a file or the folder of a series"),
    row(0, field, "vtkimage", ".vtk", "VTK legacy, structured points"),
    row(0, volume, "gipl", ".gipl .gipl.gz", "GIPL"),
    row(0, volume, "mrc", ".mrc .rec", "MRC"),
};

}  // namespace

int32_t format_count() { return static_cast<int32_t>(std::size(formats)); }

const cleft_io_format_description& format_row(int32_t index) { return formats[index]; }

const cleft_io_format_description* find_format(cleft_io_format format)
{
    for (const auto& entry : formats)
        // 0 stands for "by name" in the interface and for volumes in the table, so it never
        // matches.
        if (format > 0 && entry.format == format)
            return &entry;
    return nullptr;
}

const cleft_io_format_description* format_of_path(const std::string& path, int32_t directions)
{
    for (const auto& entry : formats)
        if (entry.format > 0 && (entry.directions & directions) && has_extension(entry, extension_of(path)))
            return &entry;
    return nullptr;
}

bool is_volume_path(const std::string& path)
{
    for (const auto& entry : formats)
        if ((entry.directions & CLEFT_IO_READS_VOLUME) && has_extension(entry, extension_of(path)))
            return true;
    return false;
}

std::string extensions_with(int32_t direction)
{
    std::string text;
    for (const auto& entry : formats)
        // Two formats may have the same extensions, as both versions of MSH do; a message names
        // them once.
        if ((entry.directions & direction) && text.find(entry.extensions) == std::string::npos)
            text += (text.empty() ? "" : " ") + std::string(entry.extensions);
    return text;
}

}  // namespace cleft::io
