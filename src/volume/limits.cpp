// Holds the frame of a volume against the limits of what can be meshed.
#include "volume/limits.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

void check_spacings(const Vec3& spacing)
{
    for (int axis = 0; axis < 3; ++axis)
        if (spacing[axis] < kLeastSpacing || spacing[axis] > kGreatestSpacing)
            throw Error(CLEFT_ERROR_ARGUMENT, "the spacing along the " + ordinal(axis) + " axis is " +
                                                  number_text(spacing[axis]) + "; it must be within " +
                                                  number_text(kLeastSpacing) + " to " + number_text(kGreatestSpacing));
    const double least = spacing.minCoeff(), greatest = spacing.maxCoeff();
    // A share of rounding errors, as affines in single precision have them.
    if (greatest > least * kGreatestStretch * (1 + 1e-6))
        throw Error(CLEFT_ERROR_ARGUMENT, "the greatest spacing, " + number_text(greatest) + ", is " +
                                              number_text(greatest / least) + " times the least, " +
                                              number_text(least) + "; it must be no more than " +
                                              number_text(kGreatestStretch) + " times");
}

// The least distance between neighbouring planes of voxels: less than the spacing if the affine shears.
double least_distance(const Frame& frame)
{
    double least = frame.grid.spacing[0] / frame.inverse.row(0).norm();
    for (int axis = 1; axis < 3; ++axis)
        least = std::min(least, frame.grid.spacing[axis] / frame.inverse.row(axis).norm());
    return least;
}

// The greatest coordinate of a box is at a corner, whatever the affine does.
double greatest_coordinate(const Frame& frame)
{
    const Vec3 extent = frame.grid.extent();
    double greatest = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 local = extent.cwiseProduct(Vec3(corner & 1, corner >> 1 & 1, corner >> 2));
        greatest = std::max(greatest, frame.to_world(local).cwiseAbs().maxCoeff());
    }
    return greatest;
}

}  // namespace

void check_limits(const Frame& frame)
{
    check_spacings(frame.grid.spacing);
    const double distance = greatest_coordinate(frame) / least_distance(frame);
    // Written so that a NaN is refused too.
    if (!(distance <= kGreatestDistance))
        throw Error(CLEFT_ERROR_ARGUMENT, "the box of the volume reaches " + number_text(distance) +
                                              " spacings away from the origin, more than " +
                                              number_text(kGreatestDistance) +
                                              ": numbers there cannot tell its points apart");
}

}  // namespace cleft
