// Linear interpolation that keeps its ends, however far they are apart.
#pragma once

namespace cleft
{

// low at 0, high at 1, exactly; positive between positive ends. low + share * (high - low) is not: where the ends are
// more digits apart than a number has, it gives 0 or less near the smaller one.
template <class Real>
constexpr Real mix(Real low, Real high, Real share)
{
    return (1 - share) * low + share * high;
}

}  // namespace cleft
