// A std::array that any integer indexes, as base/array.hpp has it for std::vector. It is for small arrays that loops
// over axes or corners index by int.
#pragma once

#include "base/to_size.hpp"

#include <array>
#include <utility>

namespace cleft
{

template <class T, size_t N>
struct FixedArray : std::array<T, N> {
    template <class Other, std::enable_if_t<std::is_same_v<Other, std::array<T, N>>, int> = 0>
    constexpr FixedArray& operator=(const Other& values)
    {
        std::array<T, N>::operator=(values);
        return *this;
    }
    template <class Integer>
    constexpr T& operator[](Integer i)
    {
        CLEFT_ASSERT(to_size(i) < N);
        return std::array<T, N>::operator[](to_size(i));
    }
    template <class Integer>
    constexpr const T& operator[](Integer i) const
    {
        CLEFT_ASSERT(to_size(i) < N);
        return std::array<T, N>::operator[](to_size(i));
    }
};

}  // namespace cleft

// For structured bindings.
template <class T, size_t N>
struct std::tuple_size<cleft::FixedArray<T, N>> : std::integral_constant<size_t, N> {
};
template <size_t I, class T, size_t N>
struct std::tuple_element<I, cleft::FixedArray<T, N>> {
    using type = T;
};
