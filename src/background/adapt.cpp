// Changes lengths, connections and places in turn, while the metric is stretched in steps: each step finds a mesh that
// is nearly what it wants, so that no operation has to make a shape that the next must mend. (From the isotropic mesh
// at once, splits run along the wrong edges: some ten million tetrahedra where forty thousand are wanted.)
#include "background/adapt.hpp"

#include "background/shape_repair.hpp"
#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "remeshing/angle_notes.hpp"
#include "remeshing/length_rounds.hpp"
#include "remeshing/springs.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// The stretch of one sweep over that of the sweep before. With larger steps, tetrahedra get worse on the way.
constexpr double kStretchOfSweep = 1.6;
// Sweeps with the whole metric. After three there is hardly anything left to change.
constexpr int kLastSweeps = 3;
// While lengths are made, angles may be as bad as this. With 28, a twentieth of the edges more are too long or short.
constexpr double kEnoughAngle = 10;  // degrees
// Sweeps before the first stretch, until a sweep hardly changes the number of tetrahedra. Each sweep can make edges a
// quarter as long.
constexpr int kMostFirstSweeps = 20;
constexpr double kSameNumber = 0.02;
// Passes over long edges, and over short ones. What is left comes again in the next sweep.
constexpr int kLengthPasses = 2;
// The flips of a sweep. With 30 degrees the worst mean ratio of the end is less.
constexpr double kFlippedAngle = 35;  // degrees
constexpr int kFlipPasses = 3;
// Of the last flips and moves, which look at angles alone: with 38, 1.5 % of the edges get too long or short for it.
constexpr double kFinalAngle = 30;  // degrees
constexpr int kFinalPasses = 15;

// A metric that jumps from voxel to voxel asks for more wherever an edge ends in a small one.
int32_t most_tets(double expected)
{
    constexpr double kGrowthOfSplits = 2, kGrowthAtLeastOfSplits = 5000;
    return static_cast<int32_t>(std::min(kGrowthOfSplits * expected + kGrowthAtLeastOfSplits, 2147483647.0));
}

class Adaptation
{
public:
    Adaptation(LocalMesh& mesh, const MetricField& metric, double expected)
        : metric_(metric),
          mesh_(mesh),
          goal_{kShortest, kLongest, kLongestMade, sine_of(kEnoughAngle), most_tets(expected)},
          repair_(mesh)
    {
    }

    void work(const Run& run)
    {
        const int steps = static_cast<int>(std::ceil(std::log(greatest_stretch(metric_)) / std::log(kStretchOfSweep)));
        const int sweeps = steps + kLastSweeps;
        Steps parts(run, Array<Step>(sweeps + 1, {nullptr, 1}));
        for (int sweep = 1; sweep <= sweeps; ++sweep)
            work_at(steps > 0 ? std::min(1.0, double(sweep) / steps) : 1, parts.next());
        repair_.improve_bad(kFinalAngle, kFinalPasses, true, parts.next());
    }

    void work_at(double stretch, const Run& run)
    {
        Steps steps(run, {{nullptr, 4}, {nullptr, 4}, {nullptr, 3}, {nullptr, 2}});
        mesh_.measure_by({&metric_, stretch}, run);
        split_long_edges(mesh_, goal_, kLengthPasses, steps.next());
        contract_short_edges(mesh_, goal_, kLengthPasses, steps.next());
        repair_.improve_bad(kFlippedAngle, kFlipPasses, false, steps.next());
        relax_springs(mesh_, goal_.enough, steps.next());
    }

private:
    const MetricField& metric_;
    LocalMesh& mesh_;
    const LengthGoal goal_;
    ShapeRepair repair_;
};

// As particles do from the beginning. Each sweep has a mesh of its own: tetrahedra that are gone would count where
// splits end.
void meet_greatest_sizes(LabelledMesh& mesh, const MetricField& metric, double expected, const Run& run)
{
    Steps steps(run, Array<Step>(kMostFirstSweeps, {nullptr, 1}));
    for (int sweep = 0; sweep < kMostFirstSweeps; ++sweep) {
        const Run part = steps.next();
        const auto before = static_cast<double>(mesh.tets.size());
        LocalMesh local(std::move(mesh), part);
        Adaptation(local, metric, expected).work_at(0, part);
        mesh = local.take(part);
        const auto tets = static_cast<double>(mesh.tets.size());
        if (std::abs(tets - before) <= kSameNumber * tets)
            return;
    }
}

}  // namespace

void adapt(TetMesh& mesh, const MetricField& metric, double expected, MadeOf made_of, const Run& run)
{
    Stage stage(run, "background.adapt", {{"background: adapting to the metric", 1}});
    Steps steps(stage.next(), {{nullptr, made_of == MadeOf::any_sizes ? 1.0 : 0}, {nullptr, 1}});
    const Run of_start = steps.next(), part = steps.next();
    LabelledMesh adapted{std::move(mesh.points), std::move(mesh.tets), {}};
    if (made_of == MadeOf::any_sizes)
        meet_greatest_sizes(adapted, metric, expected, of_start);
    LocalMesh local(std::move(adapted), part);
    Adaptation(local, metric, expected).work(part);
    note_angles(local, "background.adapt", "after", run);
    adapted = local.take(part);
    mesh = {std::move(adapted.points), std::move(adapted.tets)};
}

}  // namespace cleft
