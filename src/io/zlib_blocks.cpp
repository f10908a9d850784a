#include "io/zlib_blocks.hpp"

#include "base/parallel.hpp"

#include <zlib.h>
#include <vector>

namespace cleft::io
{

namespace
{

constexpr size_t block_bytes = size_t{1} << 18;
// Coordinates and numbers of points hardly shrink any further at a higher level, which takes three times as long.
constexpr int level = 1;

std::string compress_block(const char* data, size_t bytes)
{
    uLongf size = compressBound(static_cast<uLong>(bytes));
    std::string out(size, '\0');
    const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data),
                                 static_cast<uLong>(bytes), level);
    if (status != Z_OK)
        throw std::bad_alloc();  // the buffer is large enough: memory is all that can be missing
    out.resize(size);
    out.shrink_to_fit();
    return out;
}

}  // namespace

std::string compress_blocks(const void* data, size_t bytes, int threads)
{
    const char* from = static_cast<const char*>(data);
    const int64_t count = chunk_count(static_cast<int64_t>(bytes), static_cast<int64_t>(block_bytes));
    std::vector<std::string> blocks(static_cast<size_t>(count));
    Run run;
    run.threads = threads;
    parallel_chunks(run, static_cast<int64_t>(bytes), static_cast<int64_t>(block_bytes),
                    [&](int64_t block, int64_t begin, int64_t end) {
                        blocks[static_cast<size_t>(block)] =
                            compress_block(from + begin, static_cast<size_t>(end - begin));
                    });
    std::vector<uint64_t> header{blocks.size(), block_bytes, bytes % block_bytes};
    for (const std::string& block : blocks)
        header.push_back(block.size());
    std::string out(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(uint64_t));
    for (const std::string& block : blocks)
        out += block;
    return out;
}

bool inflate_block(const char* from, size_t from_bytes, char* to, size_t bytes)
{
    uLongf size = static_cast<uLongf>(bytes);
    return uncompress(reinterpret_cast<Bytef*>(to), &size, reinterpret_cast<const Bytef*>(from),
                      static_cast<uLong>(from_bytes)) == Z_OK &&
           size == bytes;
}

}  // namespace cleft::io
