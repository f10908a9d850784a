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
    // What is only read is not written to disk once more.
    const Block& read(int32_t block);

private:
    // Of the last two, the older one first.
    struct Held {
        int32_t slot;
        bool is_changed;
    };
    Block& held(int32_t slot, bool is_changed);
    void load(int32_t slot);
    void save(int32_t slot);

    int32_t first_;
    Array<Block> blocks_;
    KeptBytes kept_;
    Array<Held> held_;
};

}  // namespace cleft
