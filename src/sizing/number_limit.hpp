// Keeps sizes from features to a number of tetrahedra.
#pragma once

#include "base/run.hpp"
#include "sizing/sizing_options.hpp"

#include <functional>

namespace cleft
{

// Whether features give way to max_tets: sizes that are given do not.
inline bool limits_number(const SizingOptions& options)
{
    return options.max_tets > 0 && options.size <= 0 && options.size_min <= 0;
}

struct NumberLimit {
    double wanted;         // tetrahedra
    double least_feature;  // the least size of features
    double thinnest;       // side of the box
};

// Raises the least size of features until the expected number is kept to, and returns how many times; warns of it.
// `expected_at(raised)`: makes the sizes so many times raised and gives their number. `of_sizes()`: the number that the
// last sizes ask for, whatever kind of background there will be.
double keep_to_number(const NumberLimit& limit, const std::function<double(double raised)>& expected_at,
                      const std::function<double()>& of_sizes, const Run& run);

}  // namespace cleft
