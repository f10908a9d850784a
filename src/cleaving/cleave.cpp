// Runs the steps of cleaving: centres, snapping, splitting, mending.
#include "cleaving/cleave.hpp"

#include "base/stage.hpp"
#include "cleaving/assemble.hpp"
#include "cleaving/find_centres.hpp"
#include "cleaving/flat_cuts.hpp"
#include "cleaving/mend.hpp"
#include "cleaving/snap.hpp"
#include "cleaving/snapped.hpp"

namespace cleft
{

namespace
{

// Also says which points may need mending.
LabelledMesh split_centres(Centres& centres, const CleaveOptions& options, Array<int32_t>& in_doubt,
                           const Run& of_assembly)
{
    of_assembly.note("cleaving.given_up", static_cast<double>(give_up_flat_cuts(centres, options.held, of_assembly)));
    // Where tetrahedra on the other side are missing, nobody can tell whether interfaces are pinched.
    for (const int32_t v : options.held)
        centres.doubtful[v] = 0;
    in_doubt = points_in_doubt(centres, of_assembly);
    return assemble(centres, of_assembly);
}

LabelledMesh split_background(const Volume& volume, const TetMesh& background, const CleaveOptions& options,
                              Array<int32_t>& in_doubt, Steps& steps)
{
    // Centres live in here alone, so that their memory is free before mending needs its own.
    Centres centres = find_centres(volume, background, options.metric, steps);
    const SnapCounts counts = snap_vertices(centres, options.snap, options.held, steps.next());
    const Run of_assembly = steps.next();
    of_assembly.note("cleaving.snapped", static_cast<double>(counts.moved));
    of_assembly.note("cleaving.stayed", static_cast<double>(counts.stayed));
    return split_centres(centres, options, in_doubt, of_assembly);
}

LabelledMesh split_snapped(const Volume& volume, const TetMesh& background, const CleaveOptions& options,
                           const Snapped& snapped, Array<int32_t>& in_doubt, Steps& steps)
{
    Centres centres = find_centres(volume, background, options.metric, steps);
    const Run rest = steps.next();
    restore_snapped(centres, snapped, rest);
    return split_centres(centres, options, in_doubt, rest);
}

}  // namespace

LabelledMesh cleave(const Volume& volume, const TetMesh& background, const CleaveOptions& options, const Run& run)
{
    // The numbers are shares of the time, for the progress.
    Stage stage(run, "cleaving",
                {{"cleaving: materials of vertices", 3},
                 {"cleaving: cuts", 15},
                 {"cleaving: fans", 7},
                 {"cleaving: snapping", 51},
                 {"cleaving: tetrahedra", 11},
                 {"cleaving: mending", 13}});
    Array<int32_t> in_doubt;
    LabelledMesh mesh = split_background(volume, background, options, in_doubt, stage);
    mend_interfaces(mesh, in_doubt, stage.next());
    run.note("cleaving.tets", static_cast<double>(mesh.tets.size()));
    return mesh;
}

Snapped snap_background(const Volume& volume, const TetMesh& background, const CleaveOptions& options,
                        const Snapped& before, const Run& run)
{
    Steps steps(run, {{"cleaving: materials of vertices", 3},
                      {"cleaving: cuts", 15},
                      {"cleaving: fans", 7},
                      {"cleaving: snapping", 51}});
    Centres centres = find_centres(volume, background, options.metric, steps);
    const Run of_snapping = steps.next();
    if (!before.vertices.empty())
        restore_snapped(centres, before, of_snapping);
    snap_vertices(centres, options.snap, options.held, of_snapping);
    return snapped_of(centres);
}

LabelledMesh cleave_snapped(const Volume& volume, const TetMesh& background, const CleaveOptions& options,
                            const Snapped& snapped, const Run& run)
{
    Steps steps(run, {{"cleaving: materials of vertices", 3},
                      {"cleaving: cuts", 15},
                      {"cleaving: fans", 7},
                      {"cleaving: tetrahedra", 15},
                      {"cleaving: mending", 13}});
    Array<int32_t> in_doubt;
    LabelledMesh mesh = split_snapped(volume, background, options, snapped, in_doubt, steps);
    mend_interfaces(mesh, in_doubt, steps.next());
    return mesh;
}

}  // namespace cleft
