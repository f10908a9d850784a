// Which reader takes a file: the first in the table that knows its first bytes. The name of the file matters only where
// a format has no mark of its own.
#include "base/error.hpp"
#include "io/dicom_image.hpp"
#include "io/file_head.hpp"
#include "io/image_readers.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

struct Reader {
    const char* name;
    bool (*is)(const FileHead& head);
    Image (*read)(const std::string& path, const FileHead& head);
};

constexpr Reader readers[] = {
    {"DICOM", is_dicom, read_dicom_image},
    {"NRRD", is_nrrd, read_nrrd},
    {"MetaImage", is_metaimage, read_metaimage},
    {"VTK legacy", is_vtk_volume, read_vtk_volume},
    {"GIPL", is_gipl, read_gipl},
    {"MRC", is_mrc, read_mrc},
    {"TIFF", is_tiff, read_tiff},
    {"PNG", is_png, read_png},
    {"JPEG", is_jpeg, read_jpeg},
    {"BMP", is_bmp, read_bmp},
    {"known by its first bytes, but not read", has_foreign_mark, refuse_foreign_format},
    {"NIfTI or Analyze", is_nifti, read_nifti},
    {"known, but not read", is_foreign_format, refuse_foreign_format},
};

// How many bytes of a character of UTF-8 stand there; 0 if none does, or one that controls a terminal.
size_t character_at(const std::string& text, size_t at)
{
    const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const unsigned first = byte(at);
    if (first < 0x80)
        return first >= ' ' && first != 0x7f ? 1 : 0;
    const size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    bool whole = first >= 0xc2 && first <= 0xf4;
    for (size_t i = 1; i < length; ++i)
        whole = whole && byte(at + i) >> 6 == 2;
    const unsigned second = byte(at + 1);
    const bool proper = !(first == 0xe0 && second < 0xa0) && !(first == 0xed && second > 0x9f) &&
                        !(first == 0xf0 && second < 0x90) && !(first == 0xf4 && second > 0x8f) &&
                        !(first == 0xc2 && second < 0xa0);
    return whole && proper ? length : 0;
}

// Parts of damaged files stand in sentences; these must be text nevertheless.
std::string printable(const std::string& text)
{
    std::string clean;
    for (size_t at = 0; at < text.size();) {
        const size_t length = character_at(text, at);
        clean += length == 0 ? "?" : text.substr(at, length);
        at += std::max<size_t>(length, 1);
    }
    return clean;
}

Image read_by_table(const std::string& path)
{
    const FileHead head = read_head(path);
    for (const Reader& reader : readers)
        if (reader.is(head))
            return reader.read(path, head);
    throw Error(CLEFT_ERROR_FILE, "it is in no format of volumes that can be read, or it is damaged");
}

}  // namespace

Image read_image(const std::string& path)
{
    try {
        Image image = read_by_table(path);
        for (std::string& note : image.notes)
            note = printable(note);
        for (auto& [label, name] : image.names)
            name = printable(name);
        return image;
    } catch (const Error& error) {
        throw Error(error.status(), printable(error.what()));
    }
}

}  // namespace cleft::io
