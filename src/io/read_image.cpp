// Which reader takes a file: the first in the table that knows its first bytes. The name of the file matters only where
// a format has no mark of its own.
#include "io/read_image.hpp"

#include "base/error.hpp"
#include "base/utf8.hpp"
#include "io/dicom_image.hpp"
#include "io/file_head.hpp"
#include "io/image_readers.hpp"
#include "io/voxel_file.hpp"

namespace cleft::io
{

namespace
{

struct Reader {
    const char* name;
    bool (*is)(const FileHead& head);
    Image (*read)(const std::string& path, const FileHead& head);
    TensorImage (*read_tensors)(const std::string& path, const FileHead& head) = nullptr;
    StoredImage (*locate)(const std::string& path, const FileHead& head) = nullptr;
};

// Formats with a sure mark come first. Foreign marks stand before NIfTI, since Analyze is known by
// little more than a number, and foreign extensions come last.
constexpr Reader kReaders[] = {
    {"DICOM", is_dicom, read_dicom_image},
    {"NRRD", is_nrrd, read_nrrd, read_nrrd_tensors, locate_nrrd},
    {"MetaImage", is_metaimage, read_metaimage, nullptr, locate_metaimage},
    {"VTK legacy", is_vtk_volume, read_vtk_volume, read_vtk_tensors, locate_vtk_volume},
    {"VTK XML image, of which only tensors are read", is_vti, refuse_foreign_format, read_vti_tensors},
    {"GIPL", is_gipl, read_gipl},
    {"MRC", is_mrc, read_mrc},
    {"TIFF", is_tiff, read_tiff},
    {"PNG", is_png, read_png},
    {"JPEG", is_jpeg, read_jpeg},
    {"BMP", is_bmp, read_bmp},
    {"known by its first bytes, but not read", has_foreign_mark, refuse_foreign_format},
    {"NIfTI or Analyze", is_nifti, read_nifti, read_nifti_tensors, locate_nifti},
    {"known, but not read", is_foreign_format, refuse_foreign_format},
};

const Reader& reader_of(const FileHead& head)
{
    for (const Reader& reader : kReaders)
        if (reader.is(head))
            return reader;
    throw Error(CLEFT_ERROR_FILE, "it is in no format of volumes that can be read, or it is damaged");
}

// Names may carry text of the file. Control characters in it could change what a terminal shows.
void make_names_printable(Image& image)
{
    for (auto& [label, name] : image.names)
        name = printable(name);
}

}  // namespace

Image read_image(const std::string& path)
{
    const FileHead head = read_head(path);
    Image image = reader_of(head).read(path, head);
    make_names_printable(image);
    return image;
}

StoredImage locate_image(const std::string& path)
{
    const FileHead head = read_head(path);
    const Reader& reader = reader_of(head);
    if (!reader.locate && reader.read == refuse_foreign_format)
        refuse_foreign_format(path, head);
    if (!reader.locate)
        throw Error(CLEFT_ERROR_UNSUPPORTED,
                    std::string("it is ") + reader.name + ", which cannot be read by parts: " + way_to_parts(path));
    StoredImage stored = reader.locate(path, head);
    make_names_printable(stored.image);
    return stored;
}

TensorImage read_tensor_image(const std::string& path)
{
    const FileHead head = read_head(path);
    const Reader& reader = reader_of(head);
    if (!reader.read_tensors)
        throw Error(CLEFT_ERROR_UNSUPPORTED,
                    "a metric can be read from NRRD, NIfTI and VTK (legacy and .vti), and it is none");
    TensorImage tensors = reader.read_tensors(path, head);
    make_names_printable(tensors.image);
    return tensors;
}

}  // namespace cleft::io
