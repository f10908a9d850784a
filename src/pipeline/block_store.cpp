// Blocks go to disk array by array.
#include "pipeline/block_store.hpp"

#include "pipeline/block_parcels.hpp"

#include <algorithm>

namespace cleft
{

BlockStore::BlockStore(int32_t first, int32_t count, const std::string& scratch) : first_(first), blocks_(count)
{
    if (scratch.empty())
        return;
    file_ = std::make_unique<ScratchFile>(scratch);
    records_.resize(blocks_.size());
}

Block& BlockStore::at(int32_t block)
{
    const int32_t slot = block - first_;
    if (!file_)
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
    if (records_[slot].size == 0)
        return;
    Parcel parcel(file_->read(records_[slot]));
    unpack(parcel, blocks_[slot]);
}

void BlockStore::save(int32_t slot)
{
    Parcel parcel;
    pack(blocks_[slot], parcel);
    blocks_[slot] = Block();
    file_->write(records_[slot], parcel.bytes());
}

}  // namespace cleft
