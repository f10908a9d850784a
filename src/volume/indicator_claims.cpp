// Finds inputs that leave open who holds a voxel: masks with gaps or overlaps, and functions that are equal all over a
// region.
#include "volume/indicator_claims.hpp"

#include "base/counted.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <numeric>
#include <string>

namespace cleft
{

namespace
{

// Voxels per chunk: enough that handing one out costs nothing beside it.
constexpr int64_t kVoxelsClaimed = int64_t{1} << 16;

using Fields = Array<Array<float>>;

// Has every function no values but `low` and one other of its own?
bool are_masks(const Fields& fields, float low)
{
    return std::all_of(fields.begin(), fields.end(), [&](const Array<float>& field) {
        const auto other = std::find_if(field.begin(), field.end(), [&](float f) { return f != low; });
        return std::all_of(other, field.end(), [&](float f) { return f == low || f == *other; });
    });
}

float least(const Fields& fields)
{
    float low = fields[0][0];
    for (const Array<float>& field : fields)
        low = std::min(low, *std::min_element(field.begin(), field.end()));
    return low;
}

// The number of voxels at which holds(voxel).
template <class Holds>
int64_t count_voxels(int64_t voxels, const Run& run, const Holds& holds)
{
    Array<int64_t> counts(chunk_count(voxels, kVoxelsClaimed), 0);
    parallel_chunks(run, voxels, kVoxelsClaimed, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v)
            counts[chunk] += holds(v);
    });
    return std::accumulate(counts.begin(), counts.end(), int64_t{0});
}

void check_masks(const Fields& fields, float low, int64_t voxels, const Run& run)
{
    const auto claims = [&](int64_t v) {
        return std::count_if(fields.begin(), fields.end(), [&](const auto& field) { return field[v] != low; });
    };
    const auto share = [&](int64_t count) {
        return std::to_string(count) + " of " + counted(voxels, "voxel") + " " + is_or_are(count) + " in ";
    };
    const int64_t unclaimed = count_voxels(voxels, run, [&](int64_t v) { return claims(v) == 0; });
    if (unclaimed > 0)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    share(unclaimed) + "none of the " + std::to_string(fields.size()) +
                        " masks that are given as indicator functions: give the outside its own mask, or make one "
                        "label map of all masks");
    // An overlap is no error: functions always decide by the greatest value. But users of masks seldom mean it.
    const int64_t shared = count_voxels(voxels, run, [&](int64_t v) { return claims(v) > 1; });
    if (shared > 0)
        run.warn(share(shared) +
                 "several of the masks: the mask with the greatest value holds, or the first of equal ones");
}

// By voxel: whether several functions are the greatest.
Array<uint8_t> ties(const Fields& fields, int64_t voxels, const Run& run)
{
    Array<uint8_t> tied(voxels, 0);
    parallel_for(run, voxels, kVoxelsClaimed, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            float most = fields[0][v];
            for (size_t k = 1; k < fields.size(); ++k) {
                tied[v] = fields[k][v] > most ? 0 : fields[k][v] == most ? 1 : tied[v];
                most = std::max(most, fields[k][v]);
            }
        }
    });
    return tied;
}

// Are the voxels before and after it along each axis tied too?
// A sheet of ties one voxel thick is an interface that happens to pass through centres. A region is thicker along every
// axis.
bool is_inner(const Array<uint8_t>& tied, const Grid& grid, int64_t voxel)
{
    int64_t stride = 1, rest = voxel;
    for (const int32_t n : grid.dims) {
        const int64_t at = rest % n;
        if ((at > 0 && tied[voxel - stride] == 0) || (at + 1 < n && tied[voxel + stride] == 0))
            return false;
        rest /= n;
        stride *= n;
    }
    return true;
}

void check_ties(const Fields& fields, const Grid& grid, const Run& run)
{
    const Array<uint8_t> tied = ties(fields, grid.size(), run);
    const auto is_in_region = [&](int64_t v) { return tied[v] != 0 && is_inner(tied, grid, v); };
    if (count_voxels(grid.size(), run, is_in_region) == 0)
        return;
    const int64_t all = std::count(tied.begin(), tied.end(), 1);
    run.warn("several indicator functions are the greatest at " + std::to_string(all) + " of " +
             std::to_string(grid.size()) +
             " voxels, where the first of them holds: give the background its own function");
}

// A mask is no signed function: where it is 0 is the boundary, so that what is inside swells by almost a voxel.
void check_signed(const Fields& fields, float low, const Run& run)
{
    if (low == 0 && are_masks(fields, low))
        run.warn(
            "the only indicator function is 0 or one other number, like a mask; as a signed function, "
            "its inside reaches to the centres of the voxels that are 0, so make a label map of it");
}

}  // namespace

void check_claims(const Array<Array<float>>& fields, const Grid& grid, const Run& run)
{
    const float low = least(fields);
    if (fields.size() == 1)
        check_signed(fields, low, run);
    else if (are_masks(fields, low))
        check_masks(fields, low, grid.size(), run);
    else
        check_ties(fields, grid, run);
}

}  // namespace cleft
