// Looks at the beginning of a file once, for all readers.
#include "io/file_head.hpp"

#include "base/error.hpp"
#include "io/byte_source.hpp"
#include "io/file_name.hpp"

namespace cleft::io
{

namespace
{

// The longest mark is that of GIPL, in byte 252; MRC needs its header of 1024 bytes, and PNG some chunks behind its
// first.
constexpr size_t kHeadBytes = 4096;

// Of compressed files that are damaged: what comes before the damage. The reader of a format says more about it.
std::vector<unsigned char> first_bytes(ByteSource source)
{
    // Small steps: an exception in the middle loses the bytes of one step only.
    constexpr size_t kStep = 64;
    std::vector<unsigned char> bytes(kHeadBytes);
    size_t filled = 0;
    try {
        for (size_t got = kStep; got == kStep && filled < kHeadBytes; filled += got)
            got = source.read_some(bytes.data() + filled, kStep);
    } catch (const Error& error) {
        // What the system cannot read is an error at once. Damage is left to the reader, which
        // knows what is missing.
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
    // ID1 and ID2 of RFC 1952, section 2.3.1.
    head.gzip = head.bytes.size() > 2 && head.bytes[0] == 0x1f && head.bytes[1] == 0x8b;
    head.content = head.gzip ? first_bytes(ByteSource(path, Coding::deflated)) : head.bytes;
    return head;
}

}  // namespace cleft::io
