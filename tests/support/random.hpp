// Random numbers that are the same on every machine (the distributions of <random> are not).
#pragma once

#include <cstdint>

namespace cleft_test
{

// SplitMix64.
class Random
{
public:
    explicit Random(uint64_t seed) : state_(seed) {}

    uint64_t bits()
    {
        uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    // In [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double least, double greatest) { return least + (greatest - least) * unit(); }
    // In [0, count).
    uint64_t below(uint64_t count) { return bits() % count; }

private:
    uint64_t state_;
};

}  // namespace cleft_test
