// Percentiles of values that are not sorted.
#pragma once

#include "base/array.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

// Where a percentile lies among `count` values, of which there is at least one: between those of two ranks.
struct PercentilePlace {
    int64_t below, above;  // the last value has itself above
    double fraction;       // of the way from one to the other

    static PercentilePlace of(int64_t count, double share)
    {
        const double rank = share * static_cast<double>(count - 1);
        const auto below = static_cast<int64_t>(rank);
        return {below, std::min(below + 1, count - 1), rank - std::floor(rank)};
    }
    double between(double value_below, double value_above) const
    {
        return below == above ? value_below : value_below + fraction * (value_above - value_below);
    }
};

// Reorders the values, of which there is at least one.
inline double percentile(Array<double>& values, double share)
{
    // Selection instead of sorting: a few values are asked for, of millions.
    const PercentilePlace place = PercentilePlace::of(values.count(), share);
    const auto below = values.begin() + static_cast<std::ptrdiff_t>(place.below);
    std::nth_element(values.begin(), below, values.end());
    return place.below == place.above ? *below : place.between(*below, *std::min_element(below + 1, values.end()));
}

}  // namespace cleft
