// Joins the streams that libdeflate makes of the pieces of an array.
//
// A stream of deflate is a row of blocks, and a bit at the beginning of each says whether it is the last. libdeflate
// makes whole streams only. In all but the last of them that bit is cleared, and an empty block follows that fills up
// the byte (RFC 1951, section 3.2). Where the last block begins and ends only an inflater knows, which takes a small
// part of the time.
#include "io/zlib_stream.hpp"

#include "base/reported_loop.hpp"

#include <libdeflate.h>
#include <zlib.h>
#include <algorithm>
#include <array>
#include <memory>
#include <new>

namespace cleft::io
{

namespace
{

// Some hundredths of a second of work, and a few tenths of a percent more than without pieces, since deflate looks back
// by 32 kB. The size is fixed: one that depended on the number of threads would change the bytes.
constexpr int64_t kPieceBytes = int64_t{1} << 19;

struct FreeCompressor {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
};

std::string deflated(const char* data, size_t bytes, int level)
{
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(libdeflate_alloc_compressor(level));
    if (!compressor)
        throw std::bad_alloc();
    std::string out(libdeflate_deflate_compress_bound(compressor.get(), bytes), '\0');
    out.resize(libdeflate_deflate_compress(compressor.get(), data, bytes, out.data(), out.size()));
    return out;
}

// In bits from the beginning of a stream.
struct LastBlock {
    size_t begin = 0;
    size_t end = 0;
};

// An inflater without header, which ends with the object.
class Inflater
{
public:
    explicit Inflater(const std::string& stream)
    {
        constexpr int kNoHeader = -15;  // and the greatest window
        if (inflateInit2(&state_, kNoHeader) != Z_OK)
            throw std::bad_alloc();
        state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(stream.data()));
        state_.avail_in = static_cast<uInt>(stream.size());
    }
    ~Inflater() { inflateEnd(&state_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    // Goes on to the end of a block. True if it is the last.
    bool is_last_block()
    {
        constexpr int kLast = 64, kEnd = 128;  // of data_type, see the manual of zlib
        do {
            state_.next_out = out_.data();
            state_.avail_out = static_cast<uInt>(out_.size());
            const int result = inflate(&state_, Z_BLOCK);
            if (result == Z_MEM_ERROR)
                throw std::bad_alloc();
            if (result != Z_OK)
                throw Error(CLEFT_ERROR_INTERNAL, "libdeflate made what zlib cannot read");
        } while ((state_.data_type & kEnd) == 0);
        return (state_.data_type & kLast) != 0;
    }
    size_t bits_read() const { return 8 * state_.total_in - static_cast<size_t>(state_.data_type & 7); }

private:
    z_stream state_{};
    std::array<Bytef, size_t{1} << 16> out_{};
};

LastBlock last_block(const std::string& stream)
{
    Inflater inflater(stream);
    LastBlock block;
    while (!inflater.is_last_block())
        block.begin = inflater.bits_read();
    block.end = inflater.bits_read();
    return block;
}

// Makes the stream one that another may follow.
void open_end(std::string& stream)
{
    const LastBlock last = last_block(stream);
    const unsigned bit = 1U << last.begin % 8;
    stream[last.begin / 8] = static_cast<char>(static_cast<unsigned char>(stream[last.begin / 8]) & ~bit);
    // The head of an empty block that is not compressed: three zero bits, zeros up to the next byte, and its length in
    // two ways. The bits behind the last block are zeros already.
    constexpr size_t kHeadBits = 3;
    stream.resize((last.end + kHeadBits + 7) / 8, '\0');
    stream.append({'\0', '\0', '\xFF', '\xFF'});
}

}  // namespace

std::string zlib_stream(const Run& run, const void* data, size_t bytes, int level)
{
    const char* from = static_cast<const char*>(data);
    // An array without bytes has a stream, too.
    const int64_t count = std::max<int64_t>(1, chunk_count(static_cast<int64_t>(bytes), kPieceBytes));
    Array<std::string> pieces(count);
    reported_for(run, count, 1, [&](int64_t piece, int64_t) {
        const auto begin = static_cast<size_t>(piece * kPieceBytes);
        pieces[piece] = deflated(from + begin, std::min(bytes - begin, static_cast<size_t>(kPieceBytes)), level);
        if (piece + 1 < count)
            open_end(pieces[piece]);
    });
    // RFC 1950: the method and the window, and a check sum at the end, most significant byte first.
    std::string stream = "\x78\x9C";
    for (const std::string& piece : pieces)
        stream += piece;
    const uint32_t sum = libdeflate_adler32(1, data, bytes);
    for (int shift = 24; shift >= 0; shift -= 8)
        stream += static_cast<char>(sum >> shift & 0xFFU);
    return stream;
}

}  // namespace cleft::io
