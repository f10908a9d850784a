// The seams of the blocks of a rank: those between two of them, and those to the blocks of its neighbours.
#pragma once

#include "blocks/block_job.hpp"
#include "blocks/block_shares.hpp"
#include "parts/exchange.hpp"
#include "parts/parcel.hpp"

namespace cleft
{

// Work at seams: what is cut out of a block beside a seam (Side), what is done with that of both blocks, and what each
// block gets for it (Outcome).
template <class Side, class Outcome>
struct SeamWork {
    std::function<Array<Vec3>(int32_t block)> places;  // where the block may meet another one
    std::function<Side(int32_t block, const Array<Vec3>& places_of_other)> cut_out;
    std::function<std::pair<Outcome, Outcome>(int32_t lower_block, Side lower, Side upper)> work;
    std::function<void(int32_t block, const Outcome&)> put_back;
    void (*pack_side)(const Side&, Parcel&);
    void (*unpack_side)(Parcel&, Side&);
    void (*pack_outcome)(const Outcome&, Parcel&);
    void (*unpack_outcome)(Parcel&, Outcome&);
};

// Parcels between ranks that have neighbouring blocks.
class NeighbourMail
{
public:
    NeighbourMail(const BlockShares& shares, Exchange& exchange);

    // Sends one parcel down and one up, and returns what came from below and from above; all ranks call it together. A
    // parcel to where nobody is must be empty.
    std::pair<Parcel, Parcel> swap(const Parcel& down, const Parcel& up);

private:
    Exchange& exchange_;
    int32_t below_, above_;  // ranks; -1: none
};

// At the seams of a parity to the blocks of other ranks, if this rank has any. All ranks call it together.
template <class Side, class Outcome>
void work_at_outer_seams(const BlockShares& shares, int32_t parity, const SeamWork<Side, Outcome>& seams,
                         Exchange& exchange)
{
    const OwnBlocks own = shares.own(exchange);
    NeighbourMail mail(shares, exchange);
    const int32_t last = own.end() - 1;
    const bool below = own.count > 0 && own.first > 0 && (own.first - 1) % 2 == parity;
    const bool above = own.count > 0 && own.end() < shares.blocks() && last % 2 == parity;
    Parcel down, up;
    if (below)
        down.put(seams.places(own.first));
    if (above)
        up.put(seams.places(last));
    auto [from_below, from_above] = mail.swap(down, up);
    // The rank with the lower block does the work.
    Array<Vec3> places;
    Parcel side;
    if (below) {
        from_below.take(places);
        seams.pack_side(seams.cut_out(own.first, places), side);
    }
    Side lower;
    if (above) {
        from_above.take(places);
        lower = seams.cut_out(last, places);
    }
    Parcel side_above = mail.swap(side, Parcel()).second, outcome;
    if (above) {
        Side upper;
        seams.unpack_side(side_above, upper);
        const auto [of_lower, of_upper] = seams.work(last, std::move(lower), std::move(upper));
        seams.put_back(last, of_lower);
        seams.pack_outcome(of_upper, outcome);
    }
    Parcel outcome_below = mail.swap(Parcel(), outcome).first;
    if (below) {
        Outcome mine;
        seams.unpack_outcome(outcome_below, mine);
        seams.put_back(own.first, mine);
    }
}

// The work at all seams. Those of even number come first, then the others: two of a kind have no block in common.
template <class Side, class Outcome>
void work_at_seams(const BlockShares& shares, const SeamWork<Side, Outcome>& seams, Exchange& exchange)
{
    const OwnBlocks own = shares.own(exchange);
    for (int32_t parity = 0; parity < 2; ++parity) {
        for (int32_t b = own.first; b + 1 < own.end(); ++b) {
            if (b % 2 != parity)
                continue;
            // Both before anything is cut out, which leaves another surface.
            const Array<Vec3> of_lower_block = seams.places(b), of_upper_block = seams.places(b + 1);
            Side lower = seams.cut_out(b, of_upper_block), upper = seams.cut_out(b + 1, of_lower_block);
            const auto [of_lower, of_upper] = seams.work(b, std::move(lower), std::move(upper));
            seams.put_back(b, of_lower);
            seams.put_back(b + 1, of_upper);
        }
        if (exchange.ranks() > 1)
            work_at_outer_seams(shares, parity, seams, exchange);
    }
}

}  // namespace cleft
