// Shares with the least greatest work: for a bound, ranks take blocks as long as they stay below it; the least bound
// that leaves no block over is sought by halving.
#include "blocks/block_shares.hpp"

#include "parts/number_points.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// The first block of each rank, and where the blocks end that they can take.
Array<int32_t> taken_within(const Array<double>& work, int32_t ranks, double bound)
{
    Array<int32_t> first{0};
    for (int32_t r = 0; r < ranks; ++r) {
        int32_t b = first.back();
        for (double sum = 0; b < work.count() && sum + work[b] <= bound; ++b)
            sum += work[b];
        first.push_back(b);
    }
    return first;
}

}  // namespace

BlockShares BlockShares::equal(int32_t blocks, int32_t ranks)
{
    const OwnedNumbers owned(blocks, ranks);
    Array<int32_t> first;
    for (int32_t r = 0; r <= ranks; ++r)
        first.push_back(static_cast<int32_t>(owned.first(r)));
    return BlockShares(std::move(first));
}

BlockShares BlockShares::balanced(const Array<double>& work, int32_t ranks)
{
    // The bound is a thousandth above the least one, at most.
    constexpr int kHalvings = 60;
    constexpr double kNearEnough = 1.001;
    const auto blocks = static_cast<int32_t>(work.size());
    double low = *std::max_element(work.begin(), work.end()), high = std::accumulate(work.begin(), work.end(), 0.0);
    for (int i = 0; i < kHalvings && high > kNearEnough * low; ++i) {
        const double middle = 0.5 * (low + high);
        (taken_within(work, ranks, middle).back() == blocks ? high : low) = middle;
    }
    Array<int32_t> first = taken_within(work, ranks, high);
    return first.back() == blocks ? BlockShares(std::move(first)) : equal(blocks, ranks);
}

int32_t BlockShares::owner(int32_t block) const
{
    // The last that begins at the block or before: those before it that begin there too have none.
    return static_cast<int32_t>(std::upper_bound(first_.begin(), first_.end() - 1, block) - first_.begin()) - 1;
}

int32_t BlockShares::greatest_count() const
{
    int32_t most = 0;
    for (size_t r = 0; r + 1 < first_.size(); ++r)
        most = std::max(most, first_[r + 1] - first_[r]);
    return most;
}

}  // namespace cleft
