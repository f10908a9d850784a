// The blocks of a rank, in memory or on disk.
#pragma once

#include "blocks/block_job.hpp"
#include "parts/kept_bytes.hpp"

namespace cleft
{

class BlockStore
{
public:
    // Blocks from `first` on. `scratch`: the folder where they are kept; empty: they are in memory.
    BlockStore(int32_t first, int32_t count, const std::string& scratch);

    // Two blocks can be worked on at a time: a reference holds until a third block is asked for.
    Block& at(int32_t block);

private:
    void load(int32_t slot);
    void save(int32_t slot);

    int32_t first_;
    Array<Block> blocks_;
    KeptBytes kept_;
    Array<int32_t> held_;  // the last two, the older one first
};

}  // namespace cleft
