// Improves a cleaved mesh. Where that ends with a few bad tetrahedra, tries again from the cleaved mesh with higher
// aims.
#include "finishing/best_of_tries.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "finishing/hold_surfaces.hpp"
#include "improving/improve_lengths.hpp"
#include "improving/search.hpp"
#include "mesh/piece.hpp"

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
    bool holds_surfaces;
};

// Where no work on a larger mesh follows, what lies at the cut was worked on before. Holding surfaces leaves worse
// shapes than there were, and beside held points there is no room to mend these: in four blocks of AAL, 17.7 degrees.
void hold_cut(LocalMesh& mesh, const Array<int32_t>& points, bool is_open)
{
    constexpr int kSettledRings = 2;
    mesh.hold(points, is_open);
    if (is_open || points.empty())
        return;
    const Array<uint8_t> is_near = near_points(mesh.tets(), to_size(mesh.point_count()), points, kSettledRings);
    Array<int32_t> near;
    for (int32_t t = 0; t < is_near.count(); ++t)
        if (is_near[t])
            near.push_back(t);
    mesh.settle(near);
}

Try try_with(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& pipeline,
             const ImproveOptions& options, const Run& run)
{
    const double surface_error = pipeline.sizing.surface_error;
    bool holds = surface_error > 0;
    Steps steps(run, {{nullptr, 45},
                      {nullptr, pipeline.wants_lengths ? 5.0 : 0},
                      {nullptr, holds ? 10.0 : 0},
                      {nullptr, 30},
                      {nullptr, holds ? 15.0 : 0}});
    LabelledMesh from = cleaved(steps.next());
    const Region* region = pipeline.region;
    const Array<int32_t> held = region ? points_of_cut(from, region->box, run) : Array<int32_t>();
    LocalMesh mesh(std::move(from), run);
    hold_cut(mesh, held, region && region->is_cut_open);
    const Run of_lengths = steps.next();
    if (pipeline.cleave.metric)
        mesh.measure_by({pipeline.cleave.metric}, run);
    if (pipeline.wants_lengths)
        improve_lengths(mesh, target_angle(options), of_lengths);
    const Run of_surfaces = steps.next();
    holds = holds && hold_surfaces(mesh, volume, surface_error, of_surfaces);
    Shortfall left = improve(mesh, volume, options, steps.next());
    const Run of_rest = steps.next();
    if (holds)
        left = hold_surfaces_again(mesh, volume, surface_error, options, left, of_rest);
    return {std::move(mesh), left, holds};
}

}  // namespace

Improved best_of_tries(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options, const Run& run)
{
    Array<Step> shares(1 + std::size(kHigherAims), {nullptr, 0});
    shares[0].share = 1;  // others are seldom needed
    Steps steps(run, shares);
    Try best = try_with(volume, cleaved, options, options.improve, steps.next());
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
        Try other = try_with(volume, cleaved, options, higher, quiet);
        places += other.left.places;
        // On equal terms the earlier try stays.
        if (other.left.least <= best.left.least)
            continue;
        best = std::move(other);
        for (const auto& [name, value] : noted.items)
            run.note(name, value);
    }
    run.note("improving.tries", tries);
    return {std::move(best.mesh), best.holds_surfaces};
}

}  // namespace cleft
