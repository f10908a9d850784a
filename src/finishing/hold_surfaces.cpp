// Lines and edges before improving, and edges and improving in turn after it.
#include "finishing/hold_surfaces.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "fitting/relocate_lines.hpp"
#include "fitting/split_far_edges.hpp"

namespace cleft
{

namespace
{

// Degrees. With less, fewer points of lines and middles of edges are off in the end, but improving takes longer: in the
// AAL atlas, 12 and 5 left lines 0.146 voxels off instead of 0.154, for another half of the time.
constexpr double kLineFloor = 15, kSplitFloor = 12;

}  // namespace

bool hold_surfaces(LocalMesh& mesh, const Volume& volume, double error, const Run& run)
{
    Stage stage(run, "surfaces", {{nullptr, 1}, {"improving: lines", 3}, {"improving: edges", 1}});
    const Run of_sizes = stage.next();
    const Meetings meetings = find_meetings(mesh, of_sizes);
    if (!are_sizes_for(error, mesh, volume, meetings, of_sizes))
        return false;
    // This changes what far edges and meetings there are: both are found anew for the splits.
    const LinePoints lines = relocate_lines(mesh, volume, sine_of(kLineFloor), meetings, stage.next(), true);
    run.note("surfaces.off_lines", static_cast<double>(lines.off));
    const int64_t split = split_far_edges(mesh, volume, error, sine_of(kSplitFloor), stage.next());
    run.note("surfaces.far_edges", static_cast<double>(split));
    return true;
}

Shortfall hold_surfaces_again(LocalMesh& mesh, const Volume& volume, double error, const ImproveOptions& options,
                              const Shortfall& before, const Run& run)
{
    // The second round finds few.
    constexpr int kRounds = 2;
    Stage stage(run, "surfaces_again", Array<Step>(2 * kRounds, {nullptr, 1}));
    Shortfall left = before;
    for (int round = 0; round < kRounds; ++round) {
        if (split_far_edges(mesh, volume, error, sine_of(kSplitFloor), stage.next()) == 0)
            break;
        // The figures of improving are to be those of the first time, which had the work.
        Run again = stage.next();
        again.metrics = nullptr;
        const int64_t places = left.places;
        left = improve(mesh, volume, options, again);
        left.places += places;
    }
    return left;
}

}  // namespace cleft
