// A biased randomized insertion order.
#include "background/insertion_order.hpp"

#include "background/random.hpp"
#include "mesh/curve_order.hpp"

namespace cleft
{

namespace
{

// A point is in the last round with probability 7/8, else in the one before with 7/8, and so on.
constexpr int kBitsPerRound = 3;
constexpr int kMostRounds = 9;  // 8^9 are more points than there can be
constexpr uint64_t kStream = 0;

// The hash of the index alone: the order does not depend on threads, nor on what the program draws.
int rounds_from_the_last(uint64_t index)
{
    const uint64_t drawn = hashed(kStream, index);
    int round = 0;
    while (round + 1 < kMostRounds && (drawn >> (kBitsPerRound * round) & ((1u << kBitsPerRound) - 1)) == 0)
        ++round;
    return round;
}

}  // namespace

Array<int32_t> insertion_order(const Array<Vec3>& points, const Run& run)
{
    Array<Array<int32_t>> rounds(kMostRounds);
    for (size_t i = 0; i < points.size(); ++i)
        rounds[rounds_from_the_last(i)].push_back(static_cast<int32_t>(i));
    Array<int32_t> order;
    order.reserve(points.size());
    for (auto round = rounds.rbegin(); round != rounds.rend(); ++round) {
        order_along_curve(points, *round, run);
        order.insert(order.end(), round->begin(), round->end());
        *round = {};
    }
    return order;
}

}  // namespace cleft
