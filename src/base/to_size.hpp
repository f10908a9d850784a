// Numbers of points, tetrahedra, voxels and materials are signed; the standard library counts by size_t.
#pragma once

#include "base/assert.hpp"

#include <cstddef>
#include <type_traits>

namespace cleft
{

// The number as the standard library counts. It must not be negative.
template <class Integer>
constexpr size_t to_size(Integer n)
{
    static_assert(std::is_integral_v<Integer>, "an enum is no number: say by a cast that it is meant as one");
    if constexpr (std::is_signed_v<Integer>)
        CLEFT_ASSERT(n >= 0);
    return static_cast<size_t>(n);
}

}  // namespace cleft
