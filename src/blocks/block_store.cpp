// Blocks go to disk array by array.
#include "blocks/block_store.hpp"

#include "blocks/block_parcels.hpp"
#include "parts/parcel.hpp"

#include <algorithm>

namespace cleft
{

BlockStore::BlockStore(int32_t first, int32_t count, const std::string& scratch)
    : first_(first), blocks_(count), kept_(scratch)
{
}

Block& BlockStore::at(int32_t block) { return held(block - first_, true); }

const Block& BlockStore::read(int32_t block) { return held(block - first_, false); }

Block& BlockStore::held(int32_t slot, bool is_changed)
{
    if (!kept_.is_on_disk())
        return blocks_[slot];
    const auto found = std::find_if(held_.begin(), held_.end(), [&](const Held& h) { return h.slot == slot; });
    if (found != held_.end()) {
        is_changed = is_changed || found->is_changed;
        held_.erase(found);
    } else {
        if (held_.size() == 2) {
            const Held oldest = held_.front();
            if (oldest.is_changed)
                save(oldest.slot);
            blocks_[oldest.slot] = Block();
            held_.erase(held_.begin());
        }
        load(slot);
    }
    held_.push_back({slot, is_changed});
    return blocks_[slot];
}

void BlockStore::load(int32_t slot)
{
    if (!kept_.has(slot))
        return;
    Parcel parcel(kept_.get<unsigned char>(slot));
    unpack(parcel, blocks_[slot]);
}

void BlockStore::save(int32_t slot)
{
    Parcel parcel;
    pack(blocks_[slot], parcel);
    kept_.put(slot, parcel.bytes());
}

}  // namespace cleft
