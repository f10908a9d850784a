// The bytes of a file in order, plain or compressed by zlib. What a header claims is checked against the size of the
// file before anybody takes memory for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>

namespace cleft::io
{

// Deflate shrinks by this factor at most: its longest match is of 258 bytes (RFC 1951, section 3.2.5), and a match
// takes two bits at least. A header that claims more than this of its compressed data is damaged, or made to exhaust
// memory.
constexpr uintmax_t kGreatestDeflateRatio = 1032;

enum class Coding { plain, deflated };  // deflated: gzip (of several members, too) or a zlib stream

// A source can be moved, not copied. It holds a descriptor of the file until it is destroyed.
class ByteSource
{
public:
    // As a length: all bytes from the offset on.
    static constexpr uintmax_t kToTheEnd = std::numeric_limits<uintmax_t>::max();

    // `length` bytes of the file from `offset` on, which must be there. Throws Error(CLEFT_ERROR_FILE) for what is no
    // regular file, and Error(CLEFT_ERROR_FORMAT) here and below for files that are too short or damaged.
    explicit ByteSource(const std::string& path, Coding coding, uintmax_t offset = 0, uintmax_t length = kToTheEnd);
    ByteSource(ByteSource&&) noexcept;
    ByteSource& operator=(ByteSource&&) noexcept;
    ~ByteSource();

    // Throws if so many bytes cannot come any more, as far as can be known without reading them.
    void expect(uintmax_t bytes) const;
    // All of them or an Error.
    void read(void* to, size_t bytes);
    // Of a plain source, from this byte of the file on. What the other functions read next stays as it was.
    void read_at(uintmax_t offset, void* to, size_t bytes) const;
    // Less than was asked for only at the end.
    size_t read_some(void* to, size_t bytes);
    // Passes over so many bytes, which must be there. It costs a seek in a plain file and a
    // decompression in another.
    void skip(uintmax_t bytes);
    // All that is left.
    std::string read_rest();
    // The bytes of the file that were not read yet; those of a plain source are what read() gives. Where what is
    // compressed has come to its end, they are no part of it.
    uintmax_t left() const;

private:
    class State;
    std::unique_ptr<State> state_;
};

}  // namespace cleft::io
