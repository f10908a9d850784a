#include "cleaving/cleave.hpp"

#include "base/stage_timer.hpp"
#include "cleaving/assemble.hpp"
#include "cleaving/centres.hpp"
#include "cleaving/mend.hpp"
#include "cleaving/snap.hpp"

namespace cleft
{

namespace
{

// Also tells which points may need mending.
LabelledMesh split_background(const Volume& volume, const TetMesh& background, Snap rule,
                              std::vector<int32_t>& in_doubt, const Run& run)
{
    Centres centres = find_centres(volume, background, run);
    const SnapCounts counts = snap_vertices(centres, rule, run);
    run.note("cleaving.snapped", static_cast<double>(counts.moved));
    run.note("cleaving.stayed", static_cast<double>(counts.stayed));
    run.note("cleaving.given_up", static_cast<double>(give_up_flat_cuts(centres, run)));
    in_doubt = points_in_doubt(centres);
    return assemble(centres, run);
}

}  // namespace

LabelledMesh cleave(const Volume& volume, const TetMesh& background, const CleaveOptions& options, const Run& run)
{
    const StageTimer timer(run, "cleaving");
    std::vector<int32_t> in_doubt;
    LabelledMesh mesh = split_background(volume, background, options.snap, in_doubt, run);
    run.report(0.95, "cleaving: mending");
    mend_interfaces(mesh, in_doubt, run);
    run.note("cleaving.tets", static_cast<double>(mesh.tets.size()));
    run.report(1.0, "cleaving");
    return mesh;
}

}  // namespace cleft
