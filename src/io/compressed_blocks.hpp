// Arrays compressed in blocks, as VTK's XML files keep them.
#pragma once

#include <cstdint>
#include <string>

namespace cleft::io
{

// The compressed form of an array: [blocks, bytes a block, bytes of a short last block or 0, compressed bytes of each
// block], all uint64, then the blocks. The same bytes for every number of threads.
// `data` are `bytes` bytes, borrowed for the call. `threads` is at least 1. Throws std::bad_alloc.
std::string compress_blocks(const void* data, size_t bytes, int threads);

}  // namespace cleft::io
