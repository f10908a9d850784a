// What values the voxels of a field have: the facts from which their meaning is concluded.
#pragma once

#include "io/image.hpp"

#include <utility>
#include <vector>

namespace cleft::io
{

// The nearest whole number, if rounding in a format or a program that resamples explains the distance; else the value.
//
// A label L written in 8 bits with a slope comes back within L / 510: a fiftieth for labels up to 10. A value farther
// off is as likely a mixture of two labels. Large numbers of single precision lose more in a multiplication.
double snapped(double value);

// Counts over one field. "Snapped" values are those that snapped() gives.
struct FieldValues {
    static constexpr int64_t kMany = 4096;  // different values are counted up to this number

    int64_t voxels = 0;
    double least = 0;
    double greatest = 0;
    int64_t different = 0;    // different values; many + 1: more than `many`
    int64_t not_whole = 0;    // voxels that are no whole numbers
    int64_t fractions = 0;    // those of them that snapped() leaves as they are
    double greatest_off = 0;  // distance of a voxel from the nearest whole number
    // The values once snapped, ascending, and how many voxels have them; empty: more than `many`.
    std::vector<std::pair<double, int64_t>> snapped_counts;

    // Rounding would leave nothing of a small function, such as a distance in metres.
    bool rounds_to_nothing() const { return not_whole > 0 && greatest < 0.5 && least > -0.5; }
    bool is_whole() const { return fractions == 0 && !rounds_to_nothing(); }
    bool is_signed() const { return least < 0 && greatest > 0; }
    // Nothing but 0 and one positive whole number, or one of the two alone.
    bool is_mask() const;
};

// Throws Error(CLEFT_ERROR_NOT_FINITE) with the place of the first voxel that is not finite.
FieldValues values_of(const Image& image, int64_t field);

// The share of the face-neighbouring voxels that have different values (whole numbers once snapped), among those pairs
// that are not both of the most frequent value: near 1 in pictures, a half in distances rounded to whole voxels, and
// small in label maps.
double differing_neighbours(const Image& image, int64_t field, const FieldValues& values);

}  // namespace cleft::io
