// Turns shapes into numbers for colours, with operations that give the same bits on every machine.
#include "io/render/tet_measure.hpp"

#include <algorithm>
#include <cmath>

namespace cleft::io
{

namespace
{

// Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.45: within 7e-5, which is 0.004 degrees and no step
// of a colour.
double arc_cosine_degrees(double cosine)
{
    const double x = std::min(1.0, std::abs(cosine));
    constexpr double kDegrees = 57.295779513082321;
    const double angle = kDegrees * std::sqrt(1 - x) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - x * 0.0187293)));
    return cosine < 0 ? 180 - angle : angle;
}

}  // namespace

double tet_measure(cleft_io_colouring by, const Corners& corners)
{
    switch (by) {
        case CLEFT_IO_BY_ANGLE:
            return arc_cosine_degrees(angle_cosines(corners).of_least);
        case CLEFT_IO_BY_RATIO:
            return radius_ratio(corners);
        default:
            return mean_edge(corners);
    }
}

double same_log2(double value)
{
    int exponent = 0;
    const double part = std::frexp(value, &exponent);  // 0.5 to 1, exactly
    // The series of the area tangent, log m = 2 (s + s^3/3 + s^5/5 ...). |s| is at most 1/3 here, so the terms that are
    // left out are below 1e-7.
    const double s = (part - 1) / (part + 1);
    const double q = s * s;
    const double sum = s * (1 + q * (1.0 / 3 + q * (1.0 / 5 + q * (1.0 / 7 + q * (1.0 / 9 + q * (1.0 / 11))))));
    constexpr double kTwoByLog2 = 2.8853900817779268;
    return exponent + kTwoByLog2 * sum;
}

}  // namespace cleft::io
