// Gmsh numbers points as it likes; the arrays of a mesh number them one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace cleft::io
{

class PointNumbers
{
public:
    void reserve(size_t count) { numbers_.reserve(count); }
    // The number of the next point.
    void add(int64_t number) { numbers_.push_back(number); }
    // To be called when all are there; false if a number came twice.
    bool finish();
    // From 0; -1 if there is no such point.
    int32_t find(int64_t number) const;

private:
    std::vector<int64_t> numbers_;                     // in the order of the points
    std::vector<std::pair<int64_t, int32_t>> sorted_;  // empty if the numbers are consecutive
};

}  // namespace cleft::io
