// A biased randomized insertion order.
#include "delaunay/insertion_order.hpp"

#include "base/random.hpp"
#include "mesh/curve_order.hpp"

namespace cleft
{

namespace
{

constexpr int kBitsPerRound = 3;
constexpr uint64_t kStream = 0;

}  // namespace

int insertion_round(uint64_t index)
{
    const uint64_t drawn = hashed(kStream, index);
    int round = 0;
    while (round + 1 < kInsertionRounds && (drawn >> (kBitsPerRound * round) & ((1u << kBitsPerRound) - 1)) == 0)
        ++round;
    return round;
}

Array<int32_t> insertion_order(const Array<Vec3>& points, const Run& run)
{
    Array<Array<int32_t>> rounds(kInsertionRounds);
    for (size_t i = 0; i < points.size(); ++i)
        rounds[insertion_round(i)].push_back(static_cast<int32_t>(i));
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
