// A scan of the chamfer transform: plain distances to the neighbours that it has passed.
#pragma once

#include "base/array.hpp"
#include "sizing/raster_scan.hpp"

namespace cleft
{

// h(x) <= h(y) + gradation |x - y| for the neighbours y. Two opposite scans are exact, since their steps add up along
// any path.
class ChamferScan
{
public:
    ChamferScan(const Grid& grid, double gradation, Array<float>& h, const RasterScan& direction);

    void row(int32_t plane, int32_t row);

private:
    float* at(int32_t plane, int32_t row)
    {
        return h_.data() + grid_.index(0, direction_.at(1, row, grid_), direction_.at(2, plane, grid_));
    }

    const Grid& grid_;
    Array<float>& h_;
    RasterScan direction_;
    FixedArray<float, 8> step_{};  // by 4 dk + 2 dj + di
    Array<float> no_row_;          // of infinite values
};

}  // namespace cleft
