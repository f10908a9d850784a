// The steepest slope of a field between any two of 26 neighbours.
#pragma once

#include "base/grid.hpp"

#include <cmath>
#include <vector>

namespace sizing_test
{

inline double worst_slope(const cleft::Grid& grid, const std::vector<float>& h)
{
    const auto inside = [&](int32_t i, int32_t j, int32_t k) {
        return i >= 0 && i < grid.dims[0] && j >= 0 && j < grid.dims[1] && k < grid.dims[2];
    };
    double worst = 0;
    for (int32_t k = 0; k < grid.dims[2]; ++k)
        for (int32_t j = 0; j < grid.dims[1]; ++j)
            for (int32_t i = 0; i < grid.dims[0]; ++i)
                for (int n = 14; n < 27; ++n) {  // the 13 neighbours after this voxel
                    const int32_t x = i + n % 3 - 1, y = j + n / 3 % 3 - 1, z = k + n / 9 - 1;
                    if (!inside(x, y, z))
                        continue;
                    const double rise = std::abs(static_cast<double>(h[static_cast<size_t>(grid.index(i, j, k))]) -
                                                 h[static_cast<size_t>(grid.index(x, y, z))]);
                    worst = std::max(worst, rise / (grid.centre(x, y, z) - grid.centre(i, j, k)).norm());
                }
    return worst;
}

}  // namespace sizing_test
