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

Block& BlockStore::at(int32_t block)
{
    const int32_t slot = block - first_;
    if (!kept_.is_on_disk())
        return blocks_[slot];
    const auto found = std::find(held_.begin(), held_.end(), slot);
    if (found != held_.end()) {
        held_.erase(found);
    } else {
        if (held_.size() == 2) {
            save(held_.front());
            held_.erase(held_.begin());
        }
        load(slot);
    }
    held_.push_back(slot);
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
    blocks_[slot] = Block();
    kept_.put(slot, parcel.bytes());
}

}  // namespace cleft
