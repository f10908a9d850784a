// Chooses colours for angles, ratios and sizes.
#include "io/render/colour_scale.hpp"

#include "io/render/tet_measure.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

// From poor to good: red over pale yellow to blue, which people with any kind of colour blindness tell apart. The
// middle is the lightest.
constexpr Colour kPoorToGood[] = {{165, 15, 40}, {233, 112, 56}, {251, 235, 170}, {135, 190, 225}, {45, 90, 170}};
// From small to large: lighter and lighter.
constexpr Colour kSmallToLarge[] = {{52, 42, 118}, {38, 100, 150}, {52, 158, 152}, {146, 208, 132}, {252, 238, 160}};
constexpr int kSteps = 4;  // between the colours of both

constexpr double kRegularAngle = 70;  // that of the regular tetrahedron is 70.53: none has a greater least angle
constexpr double kPoorRatio = 4;      // few meshes have more than a thousandth beyond it

std::array<double, 2> natural_range(cleft_io_colouring by, const std::array<double, 2>& found)
{
    if (by == CLEFT_IO_BY_ANGLE)
        return {0, kRegularAngle};
    return by == CLEFT_IO_BY_RATIO ? std::array<double, 2>{1, kPoorRatio} : found;
}

// 1, 2 and 5 times powers of ten.
void add_decades(double low, double high, Array<double>& ticks)
{
    // Where numbers lose their digits, there are no round ones.
    constexpr double kLeast = 1e-300;
    if (!(low > kLeast))
        return;
    double power = 1;
    while (power > low)
        power /= 10;
    while (power * 10 <= low)
        power *= 10;
    while (power <= high) {
        for (const double digit : {1.0, 2.0, 5.0})
            if (digit * power >= low && digit * power <= high)
                ticks.push_back(digit * power);
        power *= 10;
    }
}

}  // namespace

ColourScale::ColourScale(cleft_io_colouring by, const std::array<double, 2>& wanted, const std::array<double, 2>& found)
    : by_(by)
{
    const bool is_given = wanted[0] != 0 || wanted[1] != 0;
    const std::array<double, 2> range = is_given ? wanted : natural_range(by, found);
    low_ = range[0];
    high_ = range[1];
    // Sizes differ by factors. A range that begins at 0 or below has no factor.
    is_logarithmic_ = by == CLEFT_IO_BY_SIZE && low_ > 0;
}

double ColourScale::place_of(double value) const
{
    if (!is_range())
        return 0.5;
    if (!(value > low_))
        return 0;
    if (value >= high_)
        return 1;
    if (is_logarithmic_)
        return (same_log2(value) - same_log2(low_)) / (same_log2(high_) - same_log2(low_));
    return (value - low_) / (high_ - low_);
}

Colour ColourScale::at(double place) const
{
    const bool is_descending = by_ == CLEFT_IO_BY_RATIO;  // the greatest ratio is the poorest
    const Colour* colours = by_ == CLEFT_IO_BY_SIZE ? kSmallToLarge : kPoorToGood;
    const double along = is_descending ? 1 - place : place;
    const int part = static_cast<int>(along * kSteps * kWhole);
    const int step = std::max(0, std::min(kSteps - 1, part / kWhole));
    return mixed(colours[step], colours[step + 1], std::max(0, std::min(kWhole, part - step * kWhole)));
}

Colour ColourScale::of(double value) const
{
    // A tetrahedron whose measure is no number is a broken one.
    if (std::isnan(value))
        return by_ == CLEFT_IO_BY_RATIO ? at(1) : at(0);
    return at(place_of(value));
}

Array<double> ColourScale::ticks() const
{
    Array<double> ticks;
    if (!is_range() || !std::isfinite(high_ - low_))
        return {low_};
    if (is_logarithmic_)
        add_decades(low_, high_, ticks);
    if (ticks.size() >= 2)
        return ticks;
    // The widest of the steps 1, 2, 5, 10 ... that gives four ticks.
    Array<double> steps;
    add_decades((high_ - low_) / 1000, (high_ - low_) / 3, steps);
    ticks.clear();
    if (steps.empty())
        return {low_};
    const double step = steps.back();
    constexpr int kMost = 9;  // twice and a half as many as three steps
    for (int i = 0; i < kMost; ++i)
        if (const double tick = (std::ceil(low_ / step) + i) * step; tick <= high_)
            ticks.push_back(tick);
    return ticks;
}

const char* ColourScale::title() const
{
    switch (by_) {
        case CLEFT_IO_BY_ANGLE:
            return "least angle";
        case CLEFT_IO_BY_RATIO:
            return "radius ratio";
        default:
            return "mean edge";
    }
}

}  // namespace cleft::io
