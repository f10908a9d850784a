// Improves a cleaved mesh. Where that ends with a few bad tetrahedra, tries again from the cleaved mesh with higher
// aims.
#include "pipeline/best_of_tries.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "fitting/relocate_lines.hpp"
#include "fitting/split_far_edges.hpp"
#include "improving/search.hpp"

#include <iterator>

namespace cleft
{

namespace
{

// More bad ones than these have a cause that another try does not take away. Of noise at 32 degrees, 50 were left by
// all of five tries.
constexpr int64_t kFew = 20;
// A try costs about as much as the first one: in a larger mesh that is too much for a few tetrahedra.
constexpr int32_t kMostTets = 200000;

struct Try {
    LocalMesh mesh;
    Shortfall left;
};

// Degrees. With less, fewer points of lines and middles of edges are off in the end, but improving takes longer: in the
// AAL atlas, 12 and 5 left lines 0.146 voxels off instead of 0.154, for another half of the time.
constexpr double kLineFloor = 15, kSplitFloor = 12;

// Lines come onto their ties before shapes are improved, and long edges of interfaces are split: improving keeps points
// on their ties, and makes good what that costs. After it, the shapes let only half of the points get there.
void hold_surfaces(LocalMesh& mesh, const Volume& volume, double error, const Run& run)
{
    const LinePoints lines = relocate_lines(mesh, volume, sine_of(kLineFloor), find_meetings(mesh, run), run, true);
    run.note("improving.off_lines", static_cast<double>(lines.off));
    run.note("improving.far_edges",
             static_cast<double>(split_far_edges(mesh, volume, error, sine_of(kSplitFloor), run)));
}

// Improving may have joined edges to longer ones, and points that moved may let go what a split would have cost before.
Shortfall split_and_improve(LocalMesh& mesh, const Volume& volume, double error, const ImproveOptions& options,
                            const Shortfall& before, const Run& run)
{
    // The second round finds few.
    constexpr int kRounds = 2;
    Shortfall left = before;
    for (int round = 0; round < kRounds; ++round) {
        if (split_far_edges(mesh, volume, error, sine_of(kSplitFloor), run) == 0)
            break;
        // The figures of improving are to be those of the first time, which had the work.
        Run again = run;
        again.metrics = nullptr;
        const int64_t places = left.places;
        left = improve(mesh, volume, options, again);
        left.places += places;
    }
    return left;
}

Try try_with(const Volume& volume, const Cleaved& cleaved, const ImproveOptions& options, double surface_error,
             const Run& run)
{
    Steps steps(run, {{nullptr, 90}, {nullptr, 10}, {nullptr, surface_error > 0 ? 2.0 : 0}});
    LocalMesh mesh(cleaved(steps.next()), run);
    if (surface_error > 0)
        hold_surfaces(mesh, volume, surface_error, run);
    Shortfall left = improve(mesh, volume, options, steps.next());
    if (surface_error > 0)
        left = split_and_improve(mesh, volume, surface_error, options, left, steps.next());
    return {std::move(mesh), left};
}

}  // namespace

LocalMesh best_of_tries(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options, const Run& run)
{
    Array<Step> shares(1 + std::size(kHigherAims), {nullptr, 0});
    shares[0].share = 1;  // others are seldom needed
    Steps steps(run, shares);
    const double surface_error = options.sizing.surface_error;
    Try best = try_with(volume, cleaved, options.improve, surface_error, steps.next());
    int tries = 1;
    int64_t places = best.left.places;
    for (const double margin : kHigherAims) {
        // A cleaved mesh is made anew for each try instead of being copied: most runs need no other try, and memory is
        // scarcest here.
        if (best.left.tets == 0 || best.left.tets > kFew || best.mesh.slot_count() > kMostTets ||
            places > most_places(best.mesh))
            break;
        ++tries;
        ImproveOptions higher = options.improve;
        higher.margin = margin;
        Metrics noted;
        Run quiet = steps.next();
        // Warnings and figures are to be those of the mesh that is returned.
        quiet.on_warning = nullptr;
        quiet.metrics = &noted;
        Try other = try_with(volume, cleaved, higher, surface_error, quiet);
        places += other.left.places;
        // On equal terms the earlier try stays.
        if (other.left.least <= best.left.least)
            continue;
        best = std::move(other);
        for (const auto& [name, value] : noted.items)
            run.note(name, value);
    }
    run.note("improving.tries", tries);
    return std::move(best.mesh);
}

}  // namespace cleft
