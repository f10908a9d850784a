// Percentiles of values that are not sorted.
#pragma once

#include "base/array.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

// Between the two nearest ranks; reorders the values, of which there is at least one.
inline double percentile(Array<double>& values, double share)
{
    // Selection instead of sorting: a few values are asked for, of millions.
    const double rank = share * static_cast<double>(values.size() - 1);
    const auto below = values.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(values.begin(), below, values.end());
    if (below + 1 == values.end())
        return *below;
    const double above = *std::min_element(below + 1, values.end());
    return *below + (rank - std::floor(rank)) * (above - *below);
}

}  // namespace cleft
