// Maps the numbers that a Gmsh file gives to its points onto 0, 1, 2 and so on.
#include "io/gmsh_numbering.hpp"

#include <algorithm>

namespace cleft::io
{

bool PointNumbers::finish()
{
    // Nearly all files number their points one by one. Then no table is needed and a search is a
    // subtraction.
    bool consecutive = true;
    for (size_t i = 1; i < numbers_.size(); ++i)
        consecutive = consecutive && numbers_[i] == numbers_[i - 1] + 1;
    if (consecutive)
        return true;
    sorted_.resize(numbers_.size());
    for (size_t i = 0; i < numbers_.size(); ++i)
        sorted_[i] = {numbers_[i], static_cast<int32_t>(i)};
    std::sort(sorted_.begin(), sorted_.end());
    // A number that stands for two points would make the corners of elements ambiguous.
    return std::adjacent_find(sorted_.begin(), sorted_.end(),
                              [](const auto& a, const auto& b) { return a.first == b.first; }) == sorted_.end();
}

int32_t PointNumbers::find(int64_t number) const
{
    if (sorted_.empty()) {
        if (numbers_.empty() || number < numbers_.front() || number > numbers_.back())
            return -1;
        return static_cast<int32_t>(number - numbers_.front());
    }
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair<int64_t, int32_t>(number, 0));
    return found != sorted_.end() && found->first == number ? found->second : -1;
}

}  // namespace cleft::io
