// Compresses pieces of an array side by side, and joins what comes out: zlib ends each but the last with a flush, which
// leaves a stream that another may follow.
#include "io/zlib_stream.hpp"

#include "base/reported_loop.hpp"

#include <zlib.h>
#include <algorithm>
#include <new>

namespace cleft::io
{

namespace
{

// Some hundredths of a second of work, and a few tenths of a percent more than without pieces, since deflate looks back
// by 32 kB. The size is fixed: one that depended on the number of threads would change the bytes.
constexpr int64_t kPieceBytes = int64_t{1} << 19;

// A deflater without header, which ends with the object.
class Deflater
{
public:
    explicit Deflater(int level)
    {
        constexpr int kNoHeader = -15;  // and the greatest window
        constexpr int kMemoryLevel = 9;
        if (deflateInit2(&state_, level, Z_DEFLATED, kNoHeader, kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::bad_alloc();
    }
    ~Deflater() { deflateEnd(&state_); }
    Deflater(const Deflater&) = delete;
    Deflater& operator=(const Deflater&) = delete;

    std::string deflated(const char* data, size_t bytes, bool is_last)
    {
        constexpr size_t kFlushBytes = 16;  // beyond the bound, which is for a finished stream
        std::string out(deflateBound(&state_, static_cast<uLong>(bytes)) + kFlushBytes, '\0');
        state_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data));
        state_.avail_in = static_cast<uInt>(bytes);
        state_.next_out = reinterpret_cast<Bytef*>(out.data());
        state_.avail_out = static_cast<uInt>(out.size());
        deflate(&state_, is_last ? Z_FINISH : Z_SYNC_FLUSH);
        // Room that is left says that all has come out.
        if (state_.avail_in > 0 || state_.avail_out == 0)
            throw Error(CLEFT_ERROR_INTERNAL, "zlib wrote more than it says it can");
        out.resize(out.size() - state_.avail_out);
        return out;
    }

private:
    z_stream state_{};
};

}  // namespace

std::string zlib_stream(const Run& run, const void* data, size_t bytes, int level)
{
    const char* from = static_cast<const char*>(data);
    // An array without bytes has a stream, too.
    const int64_t count = std::max<int64_t>(1, chunk_count(static_cast<int64_t>(bytes), kPieceBytes));
    Array<std::string> pieces(count);
    reported_for(run, count, 1, [&](int64_t piece, int64_t) {
        const auto begin = static_cast<size_t>(piece * kPieceBytes);
        pieces[piece] = Deflater(level).deflated(
            from + begin, std::min(bytes - begin, static_cast<size_t>(kPieceBytes)), piece + 1 == count);
    });
    // RFC 1950: the method and the window, and a check sum at the end, most significant byte first.
    std::string stream = "\x78\x9C";
    for (const std::string& piece : pieces)
        stream += piece;
    const uLong sum = adler32_z(1, static_cast<const Bytef*>(data), bytes);
    for (int shift = 24; shift >= 0; shift -= 8)
        stream += static_cast<char>(sum >> shift & 0xFFU);
    return stream;
}

}  // namespace cleft::io
