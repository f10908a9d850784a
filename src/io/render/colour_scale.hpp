// The colours of a measure: from its least to its greatest value.
#pragma once

#include "base/array.hpp"
#include "cleft/cleft_io.h"
#include "io/colour.hpp"

#include <array>

namespace cleft::io
{

class ColourScale
{
public:
    // `by` is no CLEFT_IO_BY_LABEL. The range of angles and ratios is fixed, so that pictures can be compared; that of
    // sizes is `found`, the least and greatest drawn. `wanted` replaces either, unless both its numbers are 0.
    ColourScale(cleft_io_colouring by, const std::array<double, 2>& wanted, const std::array<double, 2>& found);

    // One value alone has the colour of the middle.
    bool is_range() const { return high_ > low_; }
    // Values beyond the range have the colour of its end; what is no number has that of the worst.
    Colour of(double value) const;
    // 0 to 1 where the value lies on a bar of the colours, which goes from the least to the greatest.
    double place_of(double value) const;
    Colour at(double place) const;
    // Round numbers on the bar.
    Array<double> ticks() const;
    const char* title() const;

private:
    cleft_io_colouring by_;
    double low_, high_;
    bool is_logarithmic_;
};

}  // namespace cleft::io
