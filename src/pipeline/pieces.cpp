// A table by rule of snapping: how many pieces each kind of crossing adds.
#include "pipeline/pieces.hpp"

#include "base/mix.hpp"

#include <algorithm>
#include <iterator>

namespace cleft
{

namespace
{

// What is added for each tetrahedron, in tetrahedra.
struct Added {
    FixedArray<double, 3> by_materials;    // where two, three or four materials are at its corners
    double several, apart, alone;          // for each of these (crossings.hpp)
    FixedArray<double, 3> by_arrangement;  // how many times the first: on a lattice, an octree, particles
};

struct RuleRow {
    Added by_cleaving;
    Added by_improving;      // to 25 degrees
    double several_of_held;  // the same, where none can snap
};

// In the order of Snap. The figures fit balls, grains, noise, checkers, sheets, blocks, the atlas CIT168 and mickey at
// several sizes on all backgrounds: most within 5 %, white noise and grains of five voxels within 15 %.
constexpr RuleRow kRows[] = {
    {{{0.29, 0.34, 1.16}, -0.38, 0, 0.35, {1, 1, 1.3}}, {{0, 0, 0.4}, 0.35, 0.06, 0.11, {1, 1, 1}}, 12.4},
    {{{0.57, 0.9, 8.18}, -1.82, 0, 0, {1, 1, 1.91}}, {{0.03, 0, 10.5}, 0.12, 0, 0, {1, 1.92, 3}}, 60.0},
    {{{3.35, 10.1, 23.5}, 0, 0, 0, {1, 1, 1}}, {{0.75, 3.04, 33.3}, 31.1, 0, 0, {1, 1.07, 1.32}}, 60.0},
};

static_assert(std::size(kRows) == kSnapCount);

const RuleRow& row_of(Snap rule) { return kRows[static_cast<size_t>(rule)]; }

double sum(const Added& added, const Crossings& mean, Arrangement arrangement)
{
    double by_materials = 0;
    for (size_t i = 0; i < 3; ++i)
        by_materials += added.by_materials[i] * mean.materials[i + 1];
    return added.by_arrangement[static_cast<size_t>(arrangement)] * by_materials + added.several * mean.several +
           added.apart * mean.apart + added.alone * mean.alone;
}

// What improving adds at other angles: so many times what it adds at 25 degrees, and so many for each tetrahedron with
// three materials or four. Around lines where interfaces meet, few shapes reach high angles.
struct AngleRow {
    double angle, times, for_lines;
};

constexpr AngleRow kAngles[] = {{20, 0.4, 0}, {25, 1, 0}, {30, 1.2, 0.75}, {32, 1.3, 1.7}};

// Between two rows in proportion; none at 0 degrees.
AngleRow row_of_angle(double angle)
{
    AngleRow below = {0, 0, 0};
    for (const AngleRow& row : kAngles) {
        if (angle < row.angle) {
            const double share = (angle - below.angle) / (row.angle - below.angle);
            return {angle, mix(below.times, row.times, share), mix(below.for_lines, row.for_lines, share)};
        }
        below = row;
    }
    return below;
}

}  // namespace

Pieces pieces_of(const MeanCrossings& mean, const PipelineOptions& options, Arrangement arrangement)
{
    // What is held is cut as without snapping.
    const RuleRow &row = row_of(options.cleave.snap), &held = row_of(Snap::none);
    const double by_cleaving =
        sum(row.by_cleaving, mean.free, arrangement) + sum(held.by_cleaving, mean.held, arrangement);
    const double by_improving = sum(row.by_improving, mean.free, arrangement) + row.several_of_held * mean.held.several;
    const double cleaved = mean.tets() + std::max(0.0, by_cleaving);
    if (options.improve.effort == Effort::off)
        return {cleaved, cleaved};
    double lines = 0;
    for (const Crossings* part : {&mean.free, &mean.held})
        lines += part->materials[2] + part->materials[3];
    const AngleRow angle = row_of_angle(target_angle(options.improve));
    return {cleaved, cleaved + angle.times * by_improving + angle.for_lines * lines};
}

bool is_rough(const MeanCrossings& mean)
{
    // White noise with edges of 1.2 voxels has 0.15, and its numbers are within 15 %. With edges of 1.5 it has 0.3.
    constexpr double kMost = 0.2;
    return mean.several() > kMost * mean.tets();
}

}  // namespace cleft
