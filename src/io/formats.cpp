// The tables of all formats, and searches in them. The command's help, the bindings and the choice by extension all
// come from them. Who reads which volume stands in read_image.cpp.
#include "io/formats.hpp"

#include "io/file_name.hpp"
#include "io/writers.hpp"

#include <iterator>
#include <sstream>
#include <type_traits>

namespace cleft::io
{

namespace
{

using Description = cleft_io_format_description;

// A writer and a reader are functions, or nullptr where there is none: their types tell, since gcc with sanitizers
// takes no comparison of a function with null for a constant.
template <class Writer, class Reader>
constexpr MeshFormat row(cleft_io_format format, const char* name, const char* extensions, const char* text,
                         Writer write, Reader read, bool has_surface)
{
    const int32_t directions = (std::is_same_v<Writer, std::nullptr_t> ? 0 : CLEFT_IO_WRITES_MESH) |
                               (std::is_same_v<Reader, std::nullptr_t> ? 0 : CLEFT_IO_READS_MESH);
    return {{sizeof(Description), format, directions, 0, name, extensions, text}, write, read, has_surface};
}

template <void (*write)(const MeshView& mesh, const std::string& path)>
void by_one_thread(const MeshView& mesh, const std::string& path, int)
{
    write(mesh, path);
}

// The order is that of the help. Of two formats with one extension the first is the default: .msh is written as 4.1.
constexpr MeshFormat kMeshFormats[] = {
    row(CLEFT_FORMAT_VTU, "vtu", ".vtu", "VTK XML, tetrahedra with their material; binary, compressed", write_vtu,
        read_vtu, false),
    row(CLEFT_FORMAT_VTP, "vtp", ".vtp", "VTK XML, interface triangles with their materials; binary, compressed",
        write_vtp, nullptr, true),
    row(CLEFT_FORMAT_VTK, "vtk", ".vtk", "VTK legacy, tetrahedra with their material; text", by_one_thread<write_vtk>,
        read_vtk, false),
    row(CLEFT_FORMAT_MEDIT, "medit", ".mesh", "MEDIT, tetrahedra and surface triangles; text",
        by_one_thread<write_medit>, read_medit, true),
    // Both versions of MSH have one extension; the reader tells them apart by the header.
    row(CLEFT_FORMAT_MSH41, "msh41", ".msh", "Gmsh 4.1 with physical groups by name; binary",
        by_one_thread<write_msh41>, read_gmsh, true),
    row(CLEFT_FORMAT_MSH22, "msh22", ".msh", "Gmsh 2.2 with physical groups by name; text", by_one_thread<write_msh22>,
        read_gmsh, true),
    row(CLEFT_FORMAT_ABAQUS, "abaqus", ".inp", "Abaqus and CalculiX, ELSET, SURFACE and NSET; text",
        by_one_thread<write_abaqus>, nullptr, true),
    row(CLEFT_FORMAT_TETGEN, "tetgen", ".node .ele .face", "TetGen, three files; text", by_one_thread<write_tetgen>,
        read_tetgen, true),
    row(CLEFT_FORMAT_STL, "stl", ".stl", "STL of the interface triangles; binary, single precision",
        by_one_thread<write_stl>, nullptr, true),
    row(CLEFT_FORMAT_PLY, "ply", ".ply", "PLY of the interface triangles with their materials; binary",
        by_one_thread<write_ply>, nullptr, true),
    row(CLEFT_FORMAT_VTKHDF, "vtkhdf", ".vtkhdf .hdf", "VTKHDF, tetrahedra with their material; cleft-mpi writes it",
        nullptr, read_vtkhdf, false),
    row(CLEFT_FORMAT_PVTU, "pvtu", ".pvtu", "VTK XML in pieces, tetrahedra with their material; cleft-mpi writes it",
        nullptr, read_pvtu, false),
};

// A format of volumes has the number 0: it is recognised by its bytes and never chosen by the caller.
constexpr Description volume(const char* name, const char* extensions, const char* text,
                             int32_t directions = CLEFT_IO_READS_VOLUME)
{
    return {sizeof(Description), 0, directions, 0, name, extensions, text};
}

constexpr int32_t kFieldToo = CLEFT_IO_READS_VOLUME | CLEFT_IO_WRITES_SIZING;

constexpr Description kVolumeFormats[] = {
    volume("nrrd", ".nrrd", "NRRD", kFieldToo),
    volume("nhdr", ".nhdr", "NRRD with the voxels in a file of their own"),
    volume("nifti", ".nii .nii.gz", "NIfTI", kFieldToo),
    volume("analyze", ".hdr .img .img.gz", "NIfTI or Analyze 7.5 in two files"),
    volume("metaimage", ".mha", "MetaImage", kFieldToo),
    volume("mhd", ".mhd", "MetaImage with the voxels in a file of their own"),
    volume("tiff", ".tif .tiff", "TIFF stack, or a series of slices"),
    volume("png", ".png", "PNG, a series of slices"),
    volume("jpeg", ".jpg .jpeg", "JPEG, a series of slices"),
    volume("bmp", ".bmp", "BMP, a series of slices"),
    volume("dicom", ".dcm", "DICOM, a file or the folder of a series"),
    volume("vtkimage", ".vtk", "VTK legacy, structured points", kFieldToo),
    volume("gipl", ".gipl .gipl.gz", "GIPL"),
    volume("mrc", ".mrc .rec", "MRC"),
};

constexpr int32_t kMeshFormatCount = std::size(kMeshFormats);

bool has_extension(const cleft_io_format_description& row, const std::string& extension)
{
    std::istringstream list(row.extensions);
    for (std::string item; list >> item;)
        if (item == extension)
            return true;
    return false;
}

}  // namespace

int32_t format_count() { return kMeshFormatCount + static_cast<int32_t>(std::size(kVolumeFormats)); }

const Description& format_row(int32_t index)
{
    return index < kMeshFormatCount ? kMeshFormats[index].about : kVolumeFormats[index - kMeshFormatCount];
}

const MeshFormat* find_format(cleft_io_format format)
{
    for (const MeshFormat& entry : kMeshFormats)
        if (entry.about.format == format)
            return &entry;
    return nullptr;
}

const MeshFormat* format_of_path(const std::string& path, int32_t directions)
{
    for (const MeshFormat& entry : kMeshFormats)
        if ((entry.about.directions & directions) && has_extension(entry.about, extension_of(path)))
            return &entry;
    return nullptr;
}

bool is_volume_path(const std::string& path)
{
    for (const Description& entry : kVolumeFormats)
        if (has_extension(entry, extension_of(path)))
            return true;
    return false;
}

std::string extensions_with(int32_t direction)
{
    std::string text = " ";  // a blank around each, so that .vtk is not found in .vtkx
    for (int32_t i = 0; i < format_count(); ++i) {
        const Description& entry = format_row(i);
        // Two formats may have the same extensions, as both versions of MSH do; a message names them once.
        if ((entry.directions & direction) && text.find(" " + std::string(entry.extensions) + " ") == std::string::npos)
            text += std::string(entry.extensions) + " ";
    }
    return text.substr(1, text.size() - 2);
}

}  // namespace cleft::io
