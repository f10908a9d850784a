// Compresses the arrays of VTK's XML files in blocks, several at a time.
// The form is that of vtkZLibDataCompressor.
#include "io/compressed_blocks.hpp"

#include "base/parallel.hpp"
#include "io/packed_bytes.hpp"

#include <vector>

namespace cleft::io
{

namespace
{

// 256 kB: enough blocks to keep all threads busy, each far larger than the 32 kB that deflate looks back. The size is
// fixed, since one that depended on the number of threads would change the bytes of the file.
constexpr size_t kBlockBytes = size_t{1} << 18;
// Coordinates and numbers of points hardly shrink any further at a higher level, which takes twice as long.
constexpr int kBlockLevel = 1;

std::string compress_block(const char* data, size_t bytes)
{
    std::string out = packed_bytes({data, bytes}, Wrapping::zlib, kBlockLevel);
    // The bound is a little above the block's own size. All blocks together would hold the array
    // twice.
    out.shrink_to_fit();
    return out;
}

}  // namespace

std::string compress_blocks(const void* data, size_t bytes, int threads)
{
    const char* from = static_cast<const char*>(data);
    const int64_t count = chunk_count(static_cast<int64_t>(bytes), static_cast<int64_t>(kBlockBytes));
    std::vector<std::string> blocks(static_cast<size_t>(count));
    Run run;
    run.threads = threads;
    parallel_chunks(run, static_cast<int64_t>(bytes), static_cast<int64_t>(kBlockBytes),
                    [&](int64_t block, int64_t begin, int64_t end) {
                        blocks[static_cast<size_t>(block)] =
                            compress_block(from + begin, static_cast<size_t>(end - begin));
                    });
    // The header of "VTK File Formats" for compressed data: number of blocks, size of a block, size
    // of the last partial block, then the compressed sizes. The third number is 0 where the last
    // block is full.
    std::vector<uint64_t> header{blocks.size(), kBlockBytes, bytes % kBlockBytes};
    for (const std::string& block : blocks)
        header.push_back(block.size());
    std::string out(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(uint64_t));
    for (const std::string& block : blocks)
        out += block;
    return out;
}

}  // namespace cleft::io
