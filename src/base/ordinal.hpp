// How sentences for the user count things: by ordinals, which mean the same to one whose arrays begin at 0 as to one
// whose arrays begin at 1.
#pragma once

#include <cstdint>
#include <string>

namespace cleft
{

// "1st" for 0, "2nd" for 1, "12th" for 11, "23rd" for 22.
inline std::string ordinal(int64_t index)
{
    const int64_t number = index + 1;
    // 11th, 12th and 13th end as 4th does.
    const int64_t last = number % 100 / 10 == 1 ? 0 : number % 10;
    return std::to_string(number) + (last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

// "the voxel that is the 3rd along x, the 1st along y and the 9th along z", of a grid of these dims, x fastest.
template <class Dims>
std::string voxel_in_words(int64_t voxel, const Dims& dims)
{
    const int64_t row = dims[0], rows = dims[1];
    return "the voxel that is the " + ordinal(voxel % row) + " along x, the " + ordinal(voxel / row % rows) +
           " along y and the " + ordinal(voxel / row / rows) + " along z";
}

}  // namespace cleft
