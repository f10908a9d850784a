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

// Of compressed files that are damaged: what comes before the damage. The reader of a format says more about it.
std::vector<unsigned char> first_bytes(ByteSource source)
{
    constexpr size_t step = 64;
    std::vector<unsigned char> bytes(head_bytes);
    size_t filled = 0;
    try {
        for (size_t got = step; got == step && filled < head_bytes; filled += got)
            got = source.read_some(bytes.data() + filled, step);
    } catch (const Error& error) {
        if (error.status() != CLEFT_ERROR_FORMAT)
            throw;
    }
    bytes.resize(filled);
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
    head.content = head.gzip ? first_bytes(ByteSource(path, Coding::deflated)) : head.bytes;
    return head;
}

}  // namespace cleft::io
