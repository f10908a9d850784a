// Who has the blocks beside one's own, and parcels to them.
#include "blocks/block_seams.hpp"

namespace cleft
{

namespace
{

Array<unsigned char> part_of(const Received<unsigned char>& received, int32_t rank)
{
    if (rank < 0)
        return {};
    return Array<unsigned char>(received.items.begin() + received.start[rank],
                                received.items.begin() + received.start[rank + 1]);
}

}  // namespace

NeighbourMail::NeighbourMail(const BlockShares& shares, Exchange& exchange)
    : exchange_(exchange), below_(-1), above_(-1)
{
    const OwnBlocks own = shares.own(exchange);
    if (own.count > 0 && own.first > 0)
        below_ = shares.owner(own.first - 1);
    if (own.count > 0 && own.end() < shares.blocks())
        above_ = shares.owner(own.end());
}

std::pair<Parcel, Parcel> NeighbourMail::swap(const Parcel& down, const Parcel& up)
{
    Array<Array<unsigned char>> send(to_size(exchange_.ranks()));
    CLEFT_ASSERT((below_ >= 0 || down.empty()) && (above_ >= 0 || up.empty()));
    if (below_ >= 0)
        send[below_] = Array<unsigned char>(down.bytes().begin(), down.bytes().end());
    if (above_ >= 0)
        send[above_] = Array<unsigned char>(up.bytes().begin(), up.bytes().end());
    const Received<unsigned char> received = exchange_.all_to_all(send);
    return {Parcel(part_of(received, below_)), Parcel(part_of(received, above_))};
}

}  // namespace cleft
