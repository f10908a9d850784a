// Which reader takes a file: the first in the table that knows its first bytes. The name of the file matters only where
// a format has no mark of its own.
#include "base/error.hpp"
#include "io/file_head.hpp"
#include "io/image_readers.hpp"

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
    {"by ITK", is_itk_format, read_itk_image},
};

}  // namespace

Image read_image(const std::string& path)
{
    const FileHead head = read_head(path);
    for (const Reader& reader : readers)
        if (reader.is(head))
            return reader.read(path, head);
    throw Error(CLEFT_ERROR_FILE, "it is in no format of volumes that can be read, or it is damaged");
}

}  // namespace cleft::io
