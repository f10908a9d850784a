// Reproducible random numbers: a hash of what they are for, so that no state is shared between threads.
#pragma once

#include <cstdint>

namespace cleft
{

// The finalizer of Steele, Lea and Flood's SplittableRandom.
inline uint64_t hashed(uint64_t a, uint64_t b)
{
    uint64_t z = a + 0x9e3779b97f4a7c15u * (b + 1);
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

// In [0, 1).
inline double unit_random(uint64_t a, uint64_t b) { return static_cast<double>(hashed(a, b) >> 11) * 0x1p-53; }

}  // namespace cleft
