// Looks at the beginning of a file once, for all readers.
#include "io/file_head.hpp"

#include "base/error.hpp"
#include "io/byte_source.hpp"
#include "io/file_name.hpp"

namespace cleft::io
{

namespace
{

constexpr size_t head_bytes = 4096;

std::vector<unsigned char> first_bytes(ByteSource source)
{
    std::vector<unsigned char> bytes(head_bytes);
    bytes.resize(source.read_some(bytes.data(), bytes.size()));
    return bytes;
}

}  // namespace

FileHead read_head(const std::string& path)
{
    FileHead head;
    head.extension = extension_of(path);
    ByteSource plain(path, Coding::plain);
    head.size = plain.left();
    head.bytes = first_bytes(std::move(plain));
    head.gzip = head.bytes.size() > 2 && head.bytes[0] == 0x1f && head.bytes[1] == 0x8b;
    if (!head.gzip) {
        head.content = head.bytes;
        return head;
    }
    try {
        head.content = first_bytes(ByteSource(path, Coding::deflated));
    } catch (const Error& error) {
        if (error.status() != CLEFT_ERROR_FORMAT)  // what is damaged is in no format; the reader of a format says more
            throw;
    }
    return head;
}

}  // namespace cleft::io
