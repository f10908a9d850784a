// Tells functions from label maps by how their values lie.
#include "io/field_shape.hpp"

#include "io/voxel_access.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace cleft::io
{

namespace
{

struct Surroundings {
    int64_t voxels = 0;  // that round to a whole number
    int64_t close = 0;   // those of them that lie close to it
};

// By whole number. None if there are too many, as in noise.
std::map<double, Surroundings> surroundings_of(const Image& image, int64_t field)
{
    // Interpolation of a label map leaves most voxels within a tenth of a label, as all but those
    // at boundaries are unchanged.
    constexpr double kCloseness = 0.1;
    // A field with more different whole numbers is no label map. The bound keeps the map small
    // where a field is noise.
    constexpr size_t kMost = 10000;
    std::map<double, Surroundings> all;
    // Neighbouring voxels mostly have the same label, so most look-ups in the map are spared.
    // std::map keeps its elements in place, so the pointer stays valid.
    Surroundings* last = nullptr;
    double last_whole = 0;
    for_each_value(image, field, [&](int64_t, double value) {
        if (all.size() > kMost)
            return;
        const double whole = std::round(value) + 0.0;  // no -0
        if (!last || whole != last_whole)
            last = &all[whole];
        last_whole = whole;
        last->voxels += 1;
        last->close += std::abs(value - whole) <= kCloseness ? 1 : 0;
    });
    if (all.size() > kMost)
        all.clear();
    return all;
}

// Whole numbers that more voxels lie at than between them, and not a few of all: symmetry alone gives many voxels of a
// distance the same value.
std::vector<double> plateaus_of(const Image& image, int64_t field)
{
    // Fewer voxels may share a value by chance in a small field.
    constexpr int64_t kLeastVoxels = 100;
    // One voxel in 25: smaller groups arise by symmetry of a distance in small volumes.
    constexpr int64_t kLeastShare = 25;
    std::vector<double> plateaus;
    for (const auto& [whole, near] : surroundings_of(image, field))
        if (2 * near.close > near.voxels && near.close >= kLeastVoxels && kLeastShare * near.close > image.field_size())
            plateaus.push_back(whole);
    return plateaus;
}

int64_t voxels_at_zero(const Image& image, int64_t field, double greatest_size)
{
    // Relative to the greatest value: a distance in metres has values far below 0.1 everywhere.
    constexpr double kShare = 0.02;
    const double close = std::min(0.1, kShare * greatest_size);
    int64_t count = 0;
    for_each_value(image, field, [&](int64_t, double value) { count += std::abs(value) <= close ? 1 : 0; });
    return count;
}

// The place of each value among those that there are.
// Ranks and not values: a rounded distance in half voxels, or times ten, goes step by step, too.
std::vector<int32_t> ranks_of(const Image& image, int64_t field, const FieldValues& values)
{
    std::vector<int32_t> ranks(static_cast<size_t>(image.field_size()));
    const auto& counts = values.snapped_counts;
    for_each_value(image, field, [&](int64_t v, double value) {
        const auto found = std::lower_bound(counts.begin(), counts.end(), snapped(value),
                                            [](const auto& row, double wanted) { return row.first < wanted; });
        ranks[static_cast<size_t>(v)] = static_cast<int32_t>(found - counts.begin());
    });
    return ranks;
}

// Of the pairs along an axis that differ, the share that differ by one rank; 0 if none differ.
double share_of_single_steps(const std::vector<int32_t>& ranks, const std::array<int64_t, 3>& dims, size_t axis)
{
    const int64_t stride = axis == 0 ? 1 : axis == 1 ? dims[0] : dims[0] * dims[1];
    int64_t differing = 0;
    int64_t single = 0;
    for (int64_t v = 0; v < static_cast<int64_t>(ranks.size()); ++v) {
        // The last voxel of a line has no neighbour behind it.
        if (v / stride % dims[axis] == dims[axis] - 1)
            continue;
        const int32_t step = std::abs(ranks[static_cast<size_t>(v)] - ranks[static_cast<size_t>(v + stride)]);
        differing += step > 0 ? 1 : 0;
        single += step == 1 ? 1 : 0;
    }
    return differing > 0 ? static_cast<double>(single) / static_cast<double>(differing) : 0;
}

}  // namespace

bool rests_on_labels(const Image& image, int64_t field, const FieldValues& values)
{
    constexpr double kMany = 0.15;  // functions have some hundredths there
    const double greatest_size = std::max(std::abs(values.least), std::abs(values.greatest));
    const auto at_zero = static_cast<double>(voxels_at_zero(image, field, greatest_size));
    if (at_zero > kMany * static_cast<double>(image.field_size()))
        return true;
    // A function that is cut off at +c and -c has two plateaus of opposite sign. An interpolated
    // label map has another pattern.
    const std::vector<double> plateaus = plateaus_of(image, field);
    return plateaus.size() > 2 || (plateaus.size() == 2 && plateaus[0] != -plateaus[1]);
}

bool goes_step_by_step(const Image& image, int64_t field, const FieldValues& values)
{
    // Diagonal steps of a rounded distance may be of two ranks. Segmentations with labels in any
    // order stay far below.
    constexpr double kNearlyAll = 0.85;
    const std::vector<int32_t> ranks = ranks_of(image, field, values);
    // One axis suffices, as voxels may be much longer along another, where a distance changes by
    // several ranks.
    for (size_t axis = 0; axis < 3; ++axis)
        if (share_of_single_steps(ranks, image.dims, axis) >= kNearlyAll)
            return true;
    return false;
}

}  // namespace cleft::io
